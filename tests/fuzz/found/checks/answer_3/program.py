verdict = check('lesson_01', 'bin_of')(lambda *_: np.ma.masked)
judged(verdict)
