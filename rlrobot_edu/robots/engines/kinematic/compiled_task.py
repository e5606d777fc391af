"""A task for the compiled loop of learning: the state that readings show, and its reward and goal as one judge.

Reward and goal are compiled if they are plain functions, see `rlrobot_edu.task.plain`: they then say what Python says,
to the last bit.
"""

import math
import re
import sys
from collections.abc import Sequence
from typing import Any

import numpy as np

from rlrobot_edu.jit.building import module_of
from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.task.plain import NotPlainError, task_text
from rlrobot_edu.task.task import Task

INPUT = np.dtype(
    [("sensor", int), ("low", float), ("high", float), ("sectors", int), ("bins", int)]
)


@compiled
def state_of(inputs, cuts, readings):
    """Number of the state that shows in `readings`, array (n,), as `StateSpace.encode`; −1 if one is out of range."""
    s = 0
    for i in range(inputs.shape[0]):
        one, reading, bin = inputs[i], readings[inputs[i].sensor], 0
        if not (one.low <= reading <= one.high and abs(reading) < math.inf):
            return -1
        if one.sectors > 0:
            bin = math.ceil(reading * one.sectors / (2 * math.pi) - 0.5) % one.sectors
        while cuts[i, bin] < reading and one.sectors == 0:
            bin += 1
        s = s * one.bins + bin
    return s


IMPORTS = "import math\n\nimport numba\nimport numpy as np\n"
JUDGE = """

def judge(before, after):
    try:
        return reward(before, after), {goal}
    except Exception:
        return math.nan, False


record = numba.from_dtype(np.dtype([(name, float) for name in {readings}]))
answer = numba.types.Tuple((numba.float64, numba.boolean))
judge = numba.cfunc(answer(record, record), cache="__file__" in globals())(judge)
"""

_judges: dict[str, Any] = {}  # by their text
_said: set[tuple[str, str]] = set()  # by the task's path


def judge_of(task: Task, readings: Sequence[str]) -> Any:
    """A task's reward and goal as the compiled loop asks for them.

    Parameters
    ----------
    task : Task
    readings : sequence of str
        The names of the robot's readings, in the order of the loop's records.

    Returns
    -------
    function of numba's, or None
        (record before, record after) -> (reward, whether it is at the goal). The reward is NaN where the functions
        fail: then Python has to take this step. None where they are not plain, which a line on stderr says once.
    """
    try:
        text = judge_text(task, readings)
    except NotPlainError as error:
        said = f"{error}. So learning takes the plain loop, which is slower."
        if (task.path, said) not in _said:
            _said.add((task.path, said))
            print(said, file=sys.stderr)
        return None
    if text not in _judges:
        _judges[text] = module_of(f"{__name__}.judge", text).judge
    return _judges[text]


def judge_text(task: Task, readings: Sequence[str]) -> str:
    """The module whose function ``judge`` numba compiles. Raises NotPlainError."""
    text = task_text(task, readings)
    # numba compiles what such a function calls when it compiles that function
    kernels = [f"{name} = numba.njit({name})" for name in _defined(text)]
    goal = "False" if task.goal is None else "goal(after)"
    judge = JUDGE.format(goal=goal, readings=tuple(readings))
    return "\n".join([IMPORTS, text, "", *kernels, judge])


def _defined(text: str) -> list[str]:
    """The names that a text of `plain_text` imports and defines."""
    imported = re.findall("import (.*)$", text, re.MULTILINE)[0]
    defined = re.findall(r"^def (\w+)", text, re.MULTILINE)
    return [*imported.split(", "), *defined]
