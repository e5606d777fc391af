verdict = check('lesson_02', 'update')(raising(AssertionError('x' * 10**6)))
judged(verdict)
