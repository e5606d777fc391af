verdict = check('lesson_03', 'update')(raising(GeneratorExit()))
judged(verdict)
