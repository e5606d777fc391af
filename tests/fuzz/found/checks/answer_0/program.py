verdict = check('lesson_03', 'update')(raising(SystemExit(1)))
judged(verdict)
