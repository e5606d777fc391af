verdict = check('lesson_01', 'bin_of')(lambda *_: recursive())
judged(verdict)
