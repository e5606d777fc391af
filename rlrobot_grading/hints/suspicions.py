"""What is wrong with an answer that shows no known mistake: what all its cases have in common, if anything.

Each suspicion is a property of the answer's values in every case, so what it tells the learner is true.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from rlrobot_grading.answers.replay import Case, Outcome
from rlrobot_grading.answers.source import names_from_outside, unused_arguments
from rlrobot_grading.answers.values import Unkept, safely, same, show
from rlrobot_grading.hints.evidence import Evidence, Hint
from rlrobot_grading.hints.relations import relations

NAN = "nan means “not a number”: something like 0 / 0, or infinity divided by infinity, came up on the way."


def about_the_values(seen: Evidence) -> str:
    """What holds for the values of every case: rounded, of the other sign, too large by 3; or an empty text."""
    if safely(False, inspect.isgeneratorfunction, seen.answer):
        return "with yield in it this function hands out a generator, not a value. Write return."
    returns = seen.returns
    done = [
        (case, right.values, mine.values)
        for case, right, mine in _tried(seen)
        if not mine.failure
    ]
    if returns:
        values = [(right[returns], mine[returns]) for _, right, mine in done]
        told = safely("", _about_each, values, seen.got)
        if told or len(done) < len(seen.cases):
            return told  # of cases that stop with an error nothing can be said
        cases = [case for case, _, _ in done]
        told = safely("", _about_all, values)
        told = told or safely("", _about_sums, values, cases)
        return told or safely("", _about_an_argument, values, cases)
    if done and all(
        same(mine[name], case[name]) for case, _, mine in done for name in mine
    ):
        return f"nothing has changed: {' and '.join(done[0][2])} can be changed in place, as in q[s, a] = …"
    return ""


def from_the_notebook(seen: Evidence) -> Hint | None:
    """An argument is taken from the notebook, in place of the one that is given."""
    outside = safely([], names_from_outside, seen.answer, seen.right)
    if not outside:
        return None
    told = f"your function takes {outside[0]} from the notebook. It should use the argument that it is given."
    return Hint("code", told)


def about_the_code(seen: Evidence) -> str:
    """An argument is never read."""
    unused = safely([], unused_arguments, seen.answer, seen.right)
    if not unused:
        return ""
    return f"your function never looks at {unused[0]}, and the answer depends on it."


def about_the_memory(seen: Evidence) -> str:
    """What the wrong changes of a table have in common: more changes than should, or always so many times as much."""
    for name in _tables(seen.memory):
        told = safely("", _about_changes, name, seen)
        if told:
            return told
    return ""


def _tables(memory: Mapping[str, Any]) -> list[str]:
    """The tables in memory, if that holds nothing else than these and numbers: a world makes one mistake many."""
    if not all(
        isinstance(thing, np.ndarray | int | float) for thing in memory.values()
    ):
        return []
    return [name for name, thing in memory.items() if isinstance(thing, np.ndarray)]


def _about_changes(name: str, seen: Evidence) -> str:
    changes = [
        (right.values[name] - case[name], mine.values[name] - case[name])
        for case, right, mine in _tried(seen)
        if not mine.failure
    ]
    wrong = [(right, mine) for right, mine in changes if not same(right, mine)]
    if len(wrong) < 2:
        return ""
    more = [
        np.argwhere(np.isclose(right, 0) & ~np.isclose(mine, 0)).tolist()
        for right, mine in wrong
    ]
    if all(more):
        return f"more of {name} changes than should: {name}{more[0][0]}, for one, should stay as it is here."
    times = {
        round(float(t), 6)
        for right, mine in changes
        for t in mine[right != 0] / right[right != 0]
    }
    if len(times) == 1 and len(changes) == len(seen.cases):
        by = times.pop()
        if by == 0:
            return f"{name} does not change."
        return f"{name} changes by {show(by)} times as much as it should, always."
    return ""


def about_the_cases(seen: Evidence) -> str:
    """What the wrong cases have in common, and the right ones have not: an argument is True, or negative, or empty."""
    cases = seen.cases
    is_wrong = [not right.equals(mine) for _, right, mine in _tried(seen)]
    # a single case that is right or wrong may be a coincidence
    if not 2 <= sum(is_wrong) <= len(is_wrong) - 2:
        return ""
    for name in cases[0]:
        for told, holds in SIGNS.items():
            if [safely(False, holds, case[name]) for case in cases] == is_wrong:
                if told == "is False":  # where it is True, little is asked
                    return f"it is right only in the cases in which {name} is True. Compare one of the others by hand."
                return f"it is right but for the cases in which {name} {told}. What should happen there?"
    return ""


def _tried(seen: Evidence) -> list[tuple[Case, Outcome, Outcome]]:
    """The cases that were tried: each with what the right function does in it, and what the learner's does."""
    return list(zip(seen.cases, seen.expected, seen.got, strict=False))


def unlike(right: Any, mine: Any) -> str:
    """In which way a single value differs from the right one, if that can be told."""
    if isinstance(mine, str) and not isinstance(right, str):
        text = mine.strip().strip("\"'")
        if _is_number(text):
            return "this is text. Leave out the quotation marks, or str(…), so that it is a number."
        return "this is text. Numbers, and calculations, stand without quotation marks."
    if isinstance(mine, Unkept):
        return "this is neither a number nor a short list of numbers."
    if isinstance(mine, dict | set) and not isinstance(right, dict):
        kind = "dictionary" if isinstance(mine, dict) else "set"
        asked = "a number" if np.ndim(right) == 0 else "a list, or an array"
        return f"a {kind} stands here, in curly brackets. What is asked is {asked}."
    if right is None:
        return "here None is asked, and that is nothing: not even an empty list."
    if isinstance(mine, list | tuple) and _has_none(mine):
        return "None stands among these. What is asked is a number in each place."
    if callable(mine):
        return "this is a function, not its value: the round brackets that call it are missing."
    if np.asarray(mine).dtype.kind in "US" and np.asarray(right).dtype.kind not in "US":
        return "there is text in it. Leave out the quotation marks, or str(…), so that these are numbers."
    if np.iscomplexobj(np.asarray(mine)):
        return "there is a complex number in it, as a root of something negative is. What is asked is real."
    x, y = np.asarray(right, dtype=float), np.asarray(mine, dtype=float)
    if x.shape != y.shape:
        if same(x, y.squeeze()):
            return "the right value, but with brackets too many around it: take it out of its list or array."
        if x.ndim == 1 and y.ndim == 0:
            return f"this is one number. What is asked is an array of {len(x)}, one for each."
        if x.ndim == 1 and y.ndim == 1:
            told = f"its length is {len(y)}. What is asked has a length of {len(x)}."
            return f"{told} {_about_members(x, y)}".strip()
        if x.ndim and y.ndim > x.ndim:
            return "there are lists in this list. What is asked is one number in each place."
        if x.ndim > y.ndim > 0:
            return f"these are {len(y)} numbers. What is asked is a row of several for each."
        if x.ndim:
            return ""
        if np.asarray(mine).dtype.kind == "b":
            return (
                "these are several, each True or False. What is asked is one number: argmax(…) finds the first True, "
                "sum(…) counts them."
            )
        return f"these are {y.size} numbers. What is asked is one: which of them, or their largest, their sum?"
    if isinstance(mine, bool) and np.asarray(right).dtype.kind == "f":
        return f"this is {mine}, which says yes or no. What is asked is a number."
    if np.isnan(y).any() and not np.isnan(x).any():
        return NAN
    return ""


def _about_members(right: np.ndarray, mine: np.ndarray) -> str:
    """Of whole numbers, as those of states are: which one is too many, or missing."""
    if (right % 1).any() or (mine % 1).any():
        return ""
    for number in mine:
        if number not in right:
            return f"{show(int(number))}, for one, should not be there."
    for number in right:
        if number not in mine:
            return f"{show(int(number))}, for one, is missing."
    return ""


def _has_none(value: Any) -> bool:
    return value is None or (
        isinstance(value, list | tuple) and any(map(_has_none, value))
    )


def _is_number(text: str) -> bool:
    return safely(None, float, text) is not None


def _about_each(values: Sequence[tuple[Any, Any]], got: Sequence[Outcome]) -> str:
    """What is wrong with the form of each wrong value; the first is told."""
    wrong = [(x, y) for x, y in values if not same(x, y)]
    if wrong and all(y is None for _, y in wrong):
        if any(outcome.printed for outcome in got):
            return "print shows a value on the screen; return hands it to whoever called. Write return in its place."
        return "your function returns nothing here. Does every way through it end with return?"
    told = [safely("", unlike, x, y) for x, y in wrong]
    # of the first case, whose values the learner sees
    return told[0] if told and all(told) else ""


def _about_all(values: Sequence[tuple[Any, Any]]) -> str:
    """What all pairs of an expected and a returned value have in common."""
    is_wrong = any(not same(x, y) for x, y in values)
    if not is_wrong or all(same(x, values[0][0]) for x, _ in values):
        return ""
    expected, mine = (
        [np.asarray(value, dtype=float) for value in side]
        for side in zip(*values, strict=True)
    )
    return next(relations(expected, mine), "")


def _about_an_argument(values: Sequence[tuple[Any, Any]], cases: Sequence[Case]) -> str:
    """What an argument, a number, does to the right values to make them the learner's, in every case."""
    for name in cases[0]:
        numbers = [case[name] for case in cases]
        if not _are_numbers(numbers) or len(set(numbers)) < 2:
            continue
        for told, changed in CHANGES.items():
            if all(
                same(changed(np.asarray(x, dtype=float), n), y)
                for (x, y), n in zip(values, numbers, strict=True)
            ):
                return f"your numbers are the right ones {told} {name}, in every case."
    return ""


def _about_sums(values: Sequence[tuple[Any, Any]], cases: Sequence[Case]) -> str:
    """Where all right values sum to 1: what the learner's sum to."""
    right = [np.asarray(x, dtype=float) for x, _ in values]
    mine = [np.asarray(y, dtype=float) for _, y in values]
    sums = [round(float(y.sum()), 9) for y in mine]
    if not all(x.ndim and same(x.sum(), 1.0) for x in right) or set(sums) == {1.0}:
        return ""
    for name in cases[0]:
        numbers = [case[name] for case in cases]
        if len(set(map(str, numbers))) < 2 or not _are_numbers(numbers):
            continue
        if all(same(y, n) for y, n in zip(sums, numbers, strict=True)):
            return f"what is asked sums to 1, and yours sum to {name} in every case: the part 1 − {name} is missing."
        if all(same(y, 1 - n) for y, n in zip(sums, numbers, strict=True)):
            return f"what is asked sums to 1, and yours sum to 1 − {name} in every case: the part {name} is missing."
    # in the case that the learner sees
    seen = next(y for x, y in zip(right, mine, strict=True) if not same(x, y))
    if np.isnan(seen).any():
        return NAN
    if not same(seen.sum(), 1.0):
        return f"what is asked sums to 1, and yours sum to {show(round(float(seen.sum()), 3))} here."
    others = {round(total, 3) for total in sums if not np.isnan(total)} - {1.0}
    if others:
        return f"what is asked sums to 1, and in another case yours sum to {show(min(others))}."
    return ""


def _are_numbers(values: Sequence[Any]) -> bool:
    return all(isinstance(n, int | float) and not isinstance(n, bool) for n in values)


CHANGES: dict[str, Callable[[Any, float], Any]] = {
    "times": lambda x, n: x * n,
    "divided by": lambda x, n: x / n if abs(n) > 1e-100 else np.nan * x,
    "plus": lambda x, n: x + n,
    "minus": lambda x, n: x - n,
}
SIGNS: dict[str, Callable[[Any], bool]] = {
    "is True": lambda value: isinstance(value, bool | np.bool_) and bool(value),
    "is False": lambda value: isinstance(value, bool | np.bool_) and not value,
    "is 0": lambda value: (
        isinstance(value, int | float) and not isinstance(value, bool) and value == 0
    ),
    "is negative": lambda value: isinstance(value, int | float) and value < 0,
}
