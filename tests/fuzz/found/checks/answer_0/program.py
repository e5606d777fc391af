verdict = check('lesson_02', 'update')(raising(SystemExit(1)))
judged(verdict)
