verdict = check('lesson_03', 'update')(raising(AssertionError('x' * 10**6)))
judged(verdict)
