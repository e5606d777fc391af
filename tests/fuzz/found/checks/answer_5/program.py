verdict = check('lesson_01', 'bin_of')(lambda *_: endless())
judged(verdict)
