verdict = check('lesson_13', 'arm_reward')(lambda *_: np.array(3))
judged(verdict)
