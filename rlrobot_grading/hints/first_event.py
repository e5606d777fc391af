"""The first event in which a run of a loop differs from the right one, as a small table: the call and its arguments.

The numbers at the end of a run come of all its steps, so they tell nobody what to look at. An event is a call: of the
world, of a function that the loop is given, or of a function in the learner's cell that the right loop calls as well.
"""

from __future__ import annotations

import inspect
from collections.abc import Iterator, Mapping, Sequence
from types import CodeType, FunctionType
from typing import Any, NamedTuple

import numpy as np

from rlrobot_grading.answers.limits import Elsewhere
from rlrobot_grading.answers.values import differences, safely, same, show
from rlrobot_grading.hints.calls import (
    Call,
    Log,
    calls_of,
    does_no_harm,
    is_noted,
    is_same,
    other_arguments,
)
from rlrobot_grading.hints.events import differences_in
from rlrobot_grading.hints.evidence import Evidence

MOST_ROWS = 8  # of the table
MOST_ENTRIES = 2  # of an array or a list in it

Rows = tuple[tuple[str, str, str], ...]
NO_CALL = Call("no call", ())


class Event(NamedTuple):
    """A call as it should be, and the learner's; number: of the former, among all that the right loop makes."""

    wanted: Call
    got: Call
    number: int

    @property
    def order(self) -> tuple[int, int]:
        """Of several events the smallest of these comes first."""
        both = [call.steps for call in (self.wanted, self.got) if call != NO_CALL]
        return min(both), self.number

    def alone(self) -> Event:
        """Of two calls at different times the earlier: at that time the other is not made."""
        if self.got == NO_CALL or self.got.steps == self.wanted.steps:
            return self
        if self.got.steps < self.wanted.steps:
            return self._replace(wanted=NO_CALL, number=0)
        return self._replace(got=NO_CALL)


def first_event(seen: Evidence) -> Rows:
    """The rows that tell of the first event that differs, in the first wrong case; none where no event does."""
    return safely((), _first_event, seen)


def _first_event(seen: Evidence) -> Rows:
    case = seen.cases[seen.wrong[0]]
    if issubclass(type(seen.answer), Elsewhere) or not any(
        map(is_noted, case.values())
    ):
        return ()  # the calls in another process are not seen
    borrowed = _borrowed(seen)
    right = calls_of(seen, seen.right, seen.wrong[0], borrowed)
    mine = calls_of(seen, seen.answer, seen.wrong[0], borrowed)
    found = list(_of_what_is_given(seen, right, mine, borrowed))
    for name in borrowed:
        found += _of_what_is_borrowed(seen, right, mine, name, borrowed)
    if not found:
        return ()
    return _table(seen, min(found, key=lambda event: event.order))


def _borrowed(seen: Evidence) -> list[str]:
    """The functions of the cell that the right loop calls, if they are functions in the learner's cell, too."""
    if type(seen.answer) is not FunctionType or type(seen.right) is not FunctionType:
        return []
    return [
        name
        for name in _names_in(seen.right.__code__)
        if all(
            isinstance(one.__globals__.get(name), FunctionType)
            for one in (seen.right, seen.answer)
        )
    ]


def _names_in(code: CodeType) -> list[str]:
    """The names outside that a function reads, and the functions in it."""
    inner = [part for part in code.co_consts if isinstance(part, CodeType)]
    names = [*code.co_names, *(name for part in inner for name in _names_in(part))]
    return list(dict.fromkeys(names))


def _of_what_is_given(
    seen: Evidence, right: Sequence[Call], mine: Sequence[Call], borrowed: Sequence[str]
) -> Iterator[Event]:
    """The first call that differs of the world and of the functions that the loop is given."""
    numbers = [n for n, call in enumerate(right) if call.name not in borrowed]
    its = [call for call in mine if call.name not in borrowed]
    called = {call.name for call in its}
    differ = differences_in(seen, seen.wrong[0], its, called)
    if not differ or not differ[-1].does_harm:
        return
    there, here = differ[-1].place
    number = numbers[there] if there < len(numbers) else len(right)
    wanted = right[number] if number < len(right) else NO_CALL
    yield Event(wanted, its[here] if here < len(its) else NO_CALL, number)


def _of_what_is_borrowed(
    seen: Evidence,
    right: Sequence[Call],
    mine: Sequence[Call],
    name: str,
    borrowed: Sequence[str],
) -> Iterator[Event]:
    """The first call that differs of one function in the cell: when it is called, among others, may be left open."""
    theirs = [(n, call) for n, call in enumerate(right) if call.name == name]
    its = [call for call in mine if call.name == name]
    if not its or len(its[0].given) != len(theirs[0][1].given):
        return  # it has found another way
    passed: dict[tuple[int, ...], Event] = {}  # by the arguments that differ
    here = 0
    for there, (number, wanted) in enumerate(theirs):
        # who asks once more, or once too often, goes on from there
        while here + 1 < len(its) and _is_extra(wanted, its, here):
            here += 1
        got = its[here] if here < len(its) else NO_CALL
        if is_same(wanted, got):
            here += 1
            continue
        follows = theirs[there + 1][1] if there + 1 < len(theirs) else NO_CALL
        event = Event(wanted, got, number)
        others = list(other_arguments(wanted, got))
        if got == NO_CALL or is_same(follows, got):
            others = []
            logs = [Log(left_out=[number])]
        else:
            here += 1
            logs = [Log({number: change}) for change in others]
        kind = tuple(place for place, _ in others)
        if kind and kind in passed:
            yield passed[kind].alone()  # by chance it did no harm
            return
        if not all(does_no_harm(seen, seen.wrong[0], log, borrowed) for log in logs):
            yield event.alone()
            return
        passed.setdefault(kind, event)
    # each alone does no harm, and together they may
    yield from [event.alone() for kind, event in passed.items() if kind][:1]


def _is_extra(wanted: Call, its: Sequence[Call], here: int) -> bool:
    """Whether the learner's call number `here` is one more, and the next is the one that is wanted, or it again."""
    got, then = its[here], its[here + 1]
    if is_same(wanted, got):
        return False
    return is_same(wanted, then) or (here > 0 and is_same(its[here - 1], got))


def _table(seen: Evidence, event: Event) -> Rows:
    """What is known of an event: after how many steps, which call, and its arguments; rather those that differ."""
    wanted, got = event.wanted, event.got
    when = [str(call.steps) if call != NO_CALL else "" for call in (wanted, got)]
    head = [("steps so far", when[0], when[1]), ("call", wanted.name, got.name)]
    right, mine = _arguments(seen, wanted), _arguments(seen, got)
    both = right.keys() & mine.keys()
    rows: list[tuple[bool, tuple[str, str, str]]] = []
    for name in {**right, **mine}:
        if name in both and not same(right[name], mine[name]):
            differ = entries(name, right[name], mine[name])[:MOST_ENTRIES]
            rows += [(True, entry) for entry in differ]
        elif name not in seen.parameters:
            shown = [
                _in_brief(side[name]) if name in side else "" for side in (right, mine)
            ]
            rows += [(False, (name, shown[0], shown[1]))] if any(shown) else []
    room = MOST_ROWS - len(head) - sum(is_other for is_other, _ in rows)
    alike = [row for is_other, row in rows if not is_other][: max(room, 0)]
    kept = [row for is_other, row in rows if is_other or row in alike]
    return tuple([*head, *kept][:MOST_ROWS])


def _in_brief(value: Any) -> str:
    """A value that is not compared; of a queue its length, of a table nothing."""
    if isinstance(value, np.ndarray | dict):
        return ""
    return f"{len(value)} entries" if isinstance(value, list) else show(value)


def _arguments(seen: Evidence, call: Call) -> dict[str, Any]:
    """The arguments of a call by their names; of a step of the world also the state before it."""
    if call == NO_CALL:
        return {}
    name, _, method = call.name.partition(".")
    thing = seen.cases[0].get(name, seen.right.__globals__.get(name))
    function = getattr(thing, method) if method else thing
    names = inspect.signature(function).parameters
    before = {"s": call.state} if method == "step" else {}
    return {**before, **dict(zip(names, call.given, strict=False))}


def entries(name: str, right: Any, mine: Any) -> Rows:
    """What differs in two values of one argument: entries of arrays, of lists and of dictionaries; or the whole."""
    if isinstance(right, list | tuple) and isinstance(mine, list | tuple):
        if len(right) != len(mine):
            return ((f"len({name})", str(len(right)), str(len(mine))),)
        right, mine = dict(enumerate(right)), dict(enumerate(mine))
    if isinstance(right, Mapping) and isinstance(mine, Mapping):
        return tuple(
            (f"{name}[{_written(key)}]", _of(right, key), _of(mine, key))
            for key in {**right, **mine}
            if not same(right.get(key), mine.get(key))
        )
    return differences({name: right}, {name: mine})


def _written(key: Any) -> str:
    return ", ".join(map(show, key)) if isinstance(key, tuple) else show(key)


def _of(table: Mapping[Any, Any], key: Any) -> str:
    return show(table[key]) if key in table else ""
