"""Whether all answers that a cell at the end of an assignment combines are written."""

from collections.abc import Callable
from typing import Any

from rlrobot_grading.answers.source import is_unfinished


def finished(*answers: Callable[..., Any]) -> bool:
    """Whether all these functions are written; prints which are not. Their checks say whether they are right."""
    waiting = [answer.__name__ for answer in answers if is_unfinished(answer)]
    if waiting:
        print(f"This cell waits for your answers above: {', '.join(waiting)}.")
    return not waiting
