"""What may lie behind an exception: hints that name the learner's line, the name that is missing, the index."""

from __future__ import annotations

import builtins
import difflib
import math
import re
import tomllib
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from rlrobot_grading.answers.frames import HIDDEN, is_function
from rlrobot_grading.answers.limits import Failure
from rlrobot_grading.answers.source import names_of, parameters
from rlrobot_grading.answers.values import Function

MEANINGS = tomllib.loads(
    Path(__file__).with_suffix(".toml").read_text(encoding="utf-8")
)["error"]
MODULES = {
    "np": "import numpy as np",
    "numpy": "import numpy as np",
    "math": "import math",
    "random": "import random",
}
MODULES |= {"bisect": "import bisect", "itertools": "import itertools"}
# what beginners write without its np.
NUMPYS = {name for name in dir(math) if hasattr(np, name)} - {"gamma"}
NUMPYS |= {
    "argmax",
    "argmin",
    "array",
    "arange",
    "cumsum",
    "mean",
    "ones",
    "searchsorted",
    "zeros",
    "zeros_like",
}


def error_hint(
    failure: Failure,
    answer: Function,
    right: Function,
    lenders: Mapping[str, str],
) -> str:
    """The likely cause of a failure, for the learner.

    right: the function as it should be; lenders: functions of earlier lessons by name, and whose they are
    """
    if failure.kind == "TooLong" and "computing" not in failure.text:
        return (
            "it waits, as in time.sleep or input(), or a loop in it never ends. A function here only computes what it "
            "returns."
        )
    if failure.kind == "TooLong":
        return "a loop in it never ends. What would have to become false, and which of your lines makes it so?"
    if not failure.inside and "argument" in failure.text:
        return f"the function is called with ({', '.join(parameters(right))}), in this order."
    if failure.told:
        return failure.told
    if failure.kind in ("NameError", "UnboundLocalError"):
        return _about_a_name(failure, answer, right, lenders)
    if failure.kind == "IndexError" and "only integers" not in failure.text:
        return _about_an_index(failure)
    for meaning in MEANINGS:
        text = f"{failure.text}, in the line: {failure.line}"
        found = re.search(meaning["pattern"], text)
        if found:
            return meaning["means"].format(**found.groupdict())
    return ""


def _about_a_name(
    failure: Failure,
    answer: Function,
    right: Function,
    lenders: Mapping[str, str],
) -> str:
    name = next(iter(re.findall(r"'(\w+)'", failure.text)), "")
    if (
        failure.kind == "UnboundLocalError"
        or "before assignment" in failure.text
        or "not associated" in failure.text
    ):
        names = getattr(answer, "__globals__", {})
        is_called = re.search(rf"(?<!\.)\b{name}\(", failure.line)
        if is_called and (name in lenders or is_function(name, names)):
            return HIDDEN.format(name)
        return f"{name} is used before it has a value. Give it one above this line, on every way that leads here."
    if name in MODULES:
        return f"{name} must be imported first: write {MODULES[name]} in a cell above, and run it."
    if name in lenders:
        return f"{name} is {lenders[name]}."
    if name in NUMPYS:
        return f"{name} is one of numpy's: write np.{name}."
    known = {*parameters(right), *names_of(answer)} - {name}
    alike = [other for other in known if other.lower() == name.lower()]
    if not alike and name in names_of(right):
        return (
            f"{name} has no value yet in this line. Give it one first, in a line above."
        )
    alike = alike or difflib.get_close_matches(name, sorted(known), n=1, cutoff=0.6)
    alike = alike or difflib.get_close_matches(name, dir(builtins), n=1, cutoff=0.8)
    if alike:
        return f"{name} is not known here. Do you mean {alike[0]}?"
    return f"{name} is not known inside your function. It knows its arguments, and what it has given a value itself."


def _about_an_index(failure: Failure) -> str:
    found = re.search(
        r"index (-?\d+) is out of bounds for axis (\d) with size (\d+)", failure.text
    )
    if found and re.search(r"\[\s*a\w*\s*,\s*s\w*\s*\]", failure.line):
        return "the state and the action have changed places: it is q[s, a]."
    if found:
        index, axis, size = map(int, found.groups())
        which = ("rows", "columns")[axis] if axis < 2 else f"entries along axis {axis}"
        return f"the array has {size} {which}, numbered from 0, and number {index} was asked for."
    if "pop from empty" in failure.text:
        return "pop takes an entry out, and here the list has none left."
    if "too many indices" in failure.text:
        return "there are more numbers in the square brackets than the array has axes. Is it a row, or the whole table?"
    return (
        "the index is beyond the end. A list of n entries has the numbers 0 to n − 1."
    )
