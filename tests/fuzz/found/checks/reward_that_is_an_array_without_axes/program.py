verdict = check('lesson_12a', 'arm_reward')(lambda *_: np.array(3))
judged(verdict)
