verdict = check('lesson_02', 'update')(raising(GeneratorExit()))
judged(verdict)
