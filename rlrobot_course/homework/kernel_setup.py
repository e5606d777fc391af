"""What this course needs in the kernel in which a submission is graded."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from rlrobot_course.learner import my_functions
from rlrobot_grading.marking.kernel_side import NotGivenError


def set_up(
    lesson: str, exercises: Sequence[str], answers: Mapping[str, Any], taken: list[Any]
) -> None:
    """Let `take` hand out the learner's own functions of this lesson, and those of other lessons as they are given.

    answers: what the notebook has answered so far, by exercise; taken: gets all that `take` has handed out
    """
    os.environ["RLROBOT_EDU_PROGRESS"] = "0"
    take = my_functions.take
    my_functions.LESSONS = [other for other in my_functions.LESSONS if other != lesson]

    def take_here(number: str, *names: str, folder: str | Path = ".") -> Any:
        functions = []
        for name in names:
            if not lesson.startswith(number) or name not in exercises:
                functions.append(take(number, name, folder=folder))
            elif callable(answers.get(name)):
                functions.append(answers[name])
            else:
                raise NotGivenError(
                    f"{name} is an exercise of this notebook; while it is graded none is given"
                )
        taken.extend(functions)
        return functions if len(functions) > 1 else functions[0]

    my_functions.take = take_here
