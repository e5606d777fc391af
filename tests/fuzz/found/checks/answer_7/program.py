verdict = check('lesson_01', 'bin_of')(lambda *_: 10**5000)
judged(verdict)
