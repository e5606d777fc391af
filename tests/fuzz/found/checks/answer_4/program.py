verdict = check('lesson_01', 'bin_of')(lambda *_: np.array(3))
judged(verdict)
