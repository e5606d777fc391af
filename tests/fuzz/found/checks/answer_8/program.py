verdict = check('lesson_01', 'bin_of')([1] * 10**6)
judged(verdict)
