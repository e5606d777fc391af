"""Known mistakes, alone and two at a time: said where the values agree and nothing in the answer speaks against it.

Values alone may agree by chance. So the code is asked, too: whether an argument is read, whether a sign occurs.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Mapping, Sequence
from typing import Any

from rlrobot_grading.answers.source import arguments_read, read_as_given, tree_of
from rlrobot_grading.answers.values import Function, safely
from rlrobot_grading.hints.as_if import has_one_change
from rlrobot_grading.hints.evidence import Evidence, Half, Hint, Pair

# what a result is, and not what is wrong with a line: of two mistakes at once it holds only if it is seen alone
DESCRIBES = re.compile(r"\d|(this|these|that) (is|are|says)\b")
SIGNS = (ast.Lt, ast.LtE, ast.Gt, ast.GtE, ast.Eq, ast.NotEq)
MIRRORED = {ast.Lt: ast.Gt, ast.Gt: ast.Lt, ast.LtE: ast.GtE, ast.GtE: ast.LtE}


def known_mistake(seen: Evidence) -> Hint | None:
    """It computes what one of the exercise's mistakes computes, in every case; rather one that reads the same."""
    second_best = None
    for hint, wrong in seen.mistakes:
        if not seen.shows(wrong):
            continue
        unread = _read_for_nothing(seen, wrong)
        if unread and (len(seen.wrong) == 1 or _is_called_an_argument(unread, hint)):
            continue
        if _reads_the_same(seen, wrong):
            return hint
        second_best = second_best or hint
    return second_best


def _read_for_nothing(seen: Evidence, wrong: Function) -> list[str]:
    """The arguments that the answer takes as they are given, and that make no difference in `wrong`."""
    given = safely([], read_as_given, seen.answer)
    needed = safely(seen.parameters, arguments_read, seen.right)
    read = safely(seen.parameters, arguments_read, wrong)
    return [
        name
        for i, name in enumerate(seen.parameters)
        if i in given and i in needed and i not in read
    ]


def _reads_the_same(seen: Evidence, wrong: Function) -> bool:
    """Whether the answer reads the arguments that `wrong` reads, and changes those that it changes."""
    return all(
        safely(set(), read, seen.answer) == safely(set(), read, wrong)
        for read in (arguments_read, read_as_given)
    )


def _is_called_an_argument(names: Sequence[str], hint: Hint) -> bool:
    return any(re.search(rf"\b{name} is an argument", hint.text) for name in names)


def two_mistakes(seen: Evidence) -> Hint | None:
    """It makes two of the mistakes at once, and no single change of the right function does the same."""
    if not safely(True, _is_long_enough, seen):
        return None
    for pair in seen.pairs():
        if seen.shows(pair.both) and _can_both_be(seen, pair):
            return None if has_one_change(seen) else pair.hint
    return None


def _is_long_enough(seen: Evidence) -> bool:
    """Whether there is room for two mistakes: an answer of one short line has found another way."""
    return 2 * _length(seen.answer) >= _length(seen.right)


def _length(function: Function) -> int:
    """How much there is in the body of a function: names, numbers, calls, operators."""
    definition: Any = tree_of(function).body[0]
    parts = [part for line in definition.body for part in ast.walk(line)]
    return sum(not isinstance(part, ast.expr_context) for part in parts)


def _can_both_be(seen: Evidence, pair: Pair) -> bool:
    one, other = pair.halves
    if one.text == other.text or _cancel(seen, pair):
        return False
    return all(_may_be(seen, half) for half in pair.halves)


def _cancel(seen: Evidence, pair: Pair) -> bool:
    """Whether a half alone goes wrong more often than both together: then they are one thing, done and undone."""
    alone = [
        sum(not _equals(seen, half.function, i) for i in range(len(seen.got)))
        for half in pair.halves
    ]
    return max(alone) > len(seen.wrong)


def _equals(seen: Evidence, function: Function, i: int) -> bool:
    return seen.expected[i].equals(seen.mistaken(function, i, False))


def _may_be(seen: Evidence, half: Half) -> bool:
    """Whether a half of two mistakes is to be seen in the answer, if its hint is one that can be seen."""
    signs = safely(set(), _new_signs, half.edits)
    if signs and signs.isdisjoint(safely(signs, _signs_of, seen.answer)):
        return False
    if not DESCRIBES.match(half.text):
        return True
    return any(
        seen.mistaken(half.function, i, False).equals(seen.got[i]) for i in seen.wrong
    )


def _new_signs(edits: Mapping[str, str]) -> set[type[ast.AST]]:
    """The signs of comparison that edits bring in, if they change nothing else; in both directions."""
    signs: set[type[ast.AST]] = set()
    for old, new in edits.items():
        before, after = (re.sub(r"[<>=!]=?", "?", text) for text in (old, new))
        if before != after:
            return set()
        signs |= _signs_in(ast.parse(new.strip().strip(":"), mode="eval"))
    return signs


def _signs_of(answer: Function) -> set[type[ast.AST]]:
    return _signs_in(tree_of(answer))


def _signs_in(tree: ast.AST) -> set[type[ast.AST]]:
    found = {
        type(sign)
        for node in ast.walk(tree)
        if isinstance(node, ast.Compare)
        for sign in node.ops
        if isinstance(sign, SIGNS)
    }
    return found | {MIRRORED.get(sign, sign) for sign in found}
