"""What may lie behind an exception: hints that name the learner's line, the name that is missing, the index."""

from __future__ import annotations

import builtins
import difflib
import re
from collections.abc import Callable, Mapping
from typing import Any

from rlrobot_edu.course.grading.limits import Failure
from rlrobot_edu.course.grading.source import names_of, parameters

MODULES = {"np": "import numpy as np", "numpy": "import numpy as np", "math": "import math", "random": "import random"}
MODULES |= {"bisect": "import bisect", "itertools": "import itertools"}

# text of an exception (a regular expression) -> what it mostly means
MEANINGS = {
    r"SystemExit": "exit() and quit() end the whole program. Leave a function with return.",
    r"RecursionError": "your function calls itself again and again, and nothing ends it.",
    r"ZeroDivisionError": "something is divided by 0 here. With these arguments, what stands below the line?",
    r"NoneType.*(not subscriptable|not iterable)|subscript.*NoneType": "None stands here where a value is needed. "
    "Did a function that you call return nothing? append, sort and reverse do: they change the list itself.",
    r"unsupported operand.*(function|method)'": "a function stands here without the round brackets that call it.",
    r"cannot unpack non-iterable (?P<what>\w+)": "to the left of = stand several names, to the right one value.",
    r"(?P<name>\w+) takes (?P<how>\(.*\))": "{name} is called with {how}: hand over just these, in this order.",
    r"(?P<name>\w+)\(\) (takes|missing|got) ": "look at the call of {name}: which arguments does it take?",
    r"'(int|float)' object is not iterable": "for runs over a list, or over range(n). This is a single number.",
    r"OverflowError|math range error": "a number too large for the computer, as e to the power of 710 is.",
    r"only (0-dim|length-1|size-1)": "math works on single numbers. For an array take np, as in np.exp.",
    r"can't multiply sequence": "a list cannot be multiplied so. Make an array of it: np.array(…).",
    r"setting an array element with a sequence": "a whole row is written where there is room for one number.",
    r"unsupported operand.*NoneType|NoneType.*unsupported": "None cannot be computed with. Did a function that you "
    "call return nothing?",
    r"truth value of an array": "an array has many entries, and if needs one yes or no. Which entry do you mean?",
    r"not enough values to unpack|too many values to unpack": "to the left of = stand more or fewer names than there "
    "are values to the right.",
    r"cannot unpack non-iterable (?P<what>\w+)": "to the left stand several names, to the right one {what}. Pairs come "
    "from enumerate(…) and zip(…).",
    r"(?P<name>\w+)\(\) (missing|takes|got an unexpected)": "this call has too few arguments, too many, or other "
    "names. Compare it with the list in the text.",
    r"setting an array element with a sequence": "a whole row stands where one number belongs. Is an index missing?",
    r"'(?P<what>[\w.]+)' object is not callable": "round brackets call a function. A {what} is none: for an entry take "
    "square brackets.",
    r"object is not subscriptable": "square brackets take an entry out of a list or an array. What stands before them "
    "here is neither.",
    r"'(?P<what>list|tuple)' object has no attribute '(?P<name>max|min|sum|mean|argmax)'": "a {what} has no .{name}(), "
    "only arrays have. Write {name}(…), or np.{name}(…).",
    r"'dict' object has no attribute '(?P<name>\w+)'": "an entry of a dictionary is written in square brackets, with "
    'quotation marks: ["{name}"].',
    r"'(?P<what>[\w.]+)' object has no attribute '(?P<name>\w+)'": "a {what} has nothing called {name}. Is it spelled "
    "so, and is it what you think it is?",
    r"AttributeError.*'numpy' has no attribute '(?P<name>\w+)'": "numpy has nothing called {name}.",
    r"only integer|indices must be integers|only integers": "an index is a whole number. Is it a reward, or a "
    "probability, that stands in the square brackets?",
    r"could not be broadcast|shape mismatch": "two arrays are combined that have different numbers of entries.",
    r"unsupported operand.*'(list|set|tuple|dict)'|not supported between.*'(list|set|tuple|dict)'": "a whole list, or "
    "a set, stands here where a number is needed. Is its size meant, len(…)?",
    r"not supported between instances of": "two things are compared that have no order, as a number and a whole list. "
    "Compare with one entry at a time.",
    r"operand type\(s\) for \^": "a power is written with two stars, as in gamma**k. ^ means something else in Python.",
    r"cannot be interpreted as an integer": "a whole number is needed here. range wants a length: range(len(…)).",
    r"is not in list": "index(…) finds only what is itself in the list.",
    r"can only concatenate": "two kinds of things are put together with +, as a text and a number. Which is which?",
    r"must be real number, not (?P<what>\w+)": "a number is needed here, and a {what} was given.",
    r"'(int|float|numpy\.\w+)' object is not iterable": "a single number stands here where a list is needed.",
    r"object of type '(int|float|NoneType)' has no len": "only a list, an array or the like has a length. What stands "
    "in the brackets here is none.",
    r"unhashable": "a list cannot be in a set or be a key. Take its entries, or a tuple.",
    r"KeyError": "this key is not in the dictionary. Print its keys, and compare the spelling.",
    r"math domain error": "a logarithm or a root was taken of a number that has none.",
    r"object does not support item assignment": "a tuple, or a text, cannot be changed. Make a list of it.",
    r"is empty|empty sequence|zero-size array": "this list is empty here, and has no largest, smallest or first entry.",
    r"NotImplementedError": "you have left this for later: now is the time.",
}


def error_hint(
    failure: Failure, answer: Callable[..., Any], right: Callable[..., Any], lenders: Mapping[str, str]
) -> str:
    """The likely cause of a failure, for the learner.

    right: the function as it should be; lenders: functions of earlier lessons by name, and whose they are
    """
    if failure.kind == "TooLong":
        return "a loop in it never ends. What would have to become false, and which of your lines makes it so?"
    if not failure.inside and "argument" in failure.text:
        return f"the function is called with ({', '.join(parameters(right))}), in this order."
    if failure.kind in ("NameError", "UnboundLocalError"):
        return _about_a_name(failure, answer, right, lenders)
    if failure.kind == "IndexError" and "only integers" not in failure.text:
        return _about_an_index(failure)
    for pattern, meaning in MEANINGS.items():
        if found := re.search(pattern, failure.text):
            return meaning.format(**found.groupdict())
    return ""


def _about_a_name(
    failure: Failure, answer: Callable[..., Any], right: Callable[..., Any], lenders: Mapping[str, str]
) -> str:
    name = next(iter(re.findall(r"'(\w+)'", failure.text)), "")
    if failure.kind == "UnboundLocalError" or "before assignment" in failure.text or "not associated" in failure.text:
        return f"{name} is used before it has a value. Give it one before the loop, or on every way that leads here."
    if name in MODULES:
        return f"{name} must be imported first: write {MODULES[name]} in a cell above, and run it."
    if name in lenders:
        return f"{name} is {lenders[name]}."
    known = {*parameters(right), *names_of(answer)} - {name}
    alike = difflib.get_close_matches(name, sorted(known), n=1, cutoff=0.6)
    alike = alike or difflib.get_close_matches(name, dir(builtins), n=1, cutoff=0.8)
    if alike:
        return f"{name} is not known here. Do you mean {alike[0]}?"
    return f"{name} is not known inside your function. It knows its arguments, and what it has given a value itself."


def _about_an_index(failure: Failure) -> str:
    found = re.search(r"index (-?\d+) is out of bounds for axis (\d) with size (\d+)", failure.text)
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
    return "the index is beyond the end. A list of n entries has the numbers 0 to n − 1."
