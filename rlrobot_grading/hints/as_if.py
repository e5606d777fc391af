"""Which one change of the right function makes it do what an answer does, told in the names of the answer."""

from __future__ import annotations

import ast
import builtins
import inspect
import re
import textwrap
import time
import warnings
from collections import defaultdict
from collections.abc import Iterator, Mapping
from functools import cache
from itertools import islice, product
from types import FunctionType
from typing import Any

from rlrobot_grading.answers.source import (
    names_of,
    parameters,
    read_as_given,
    tree_of,
)
from rlrobot_grading.answers.values import Function, safely
from rlrobot_grading.hints.changed import become, changed, made, quoted
from rlrobot_grading.hints.evidence import Evidence
from rlrobot_grading.hints.further_changes import (
    REDUCED,
    changes_everywhere,
    further_changes,
    handed_over,
    put_around,
)
from rlrobot_grading.hints.pieces import WORD, code_of, may_be_told
from rlrobot_grading.hints.simple_changes import CALLED, simple_changes

SECONDS = 4.0  # of computing, after which a learner is told that no hint is known
MOST = 1000  # changes that are tried, the simple ones first
# the likely ones first
KINDS = (
    changes_everywhere,
    simple_changes,
    further_changes,
    handed_over,
    put_around,
)
FAR_FETCHED = 4  # the rank of changes that need two wrong cases as evidence
NEVER = 99  # the rank of a change that nobody makes
AROUND = re.compile(r"(?: in| of|:) “[^”]*”(?:, not “[^”]*”)?$")
QUOTED = re.compile(r"“([^”]*)”")
ALWAYS = re.compile(r"“(\w+)” were always (.+)")
IN_PLACE = re.compile(r"“(\w+)” (?:(?:stood )?in place of “(\w+)”|were squared)")


def one_change(seen: Evidence) -> str:
    """What differs in one thing from the right function and does in every case what the answer does."""
    for said in _changes_that_fit(seen):
        words = safely("", _in_its_words, said, seen)
        if words:
            return f"it answers as if {words}."
    return ""


def has_one_change(seen: Evidence) -> bool:
    """Whether there is such a function, in whatever words."""
    return any(True for _ in _changes_that_fit(seen))


def _changes_that_fit(seen: Evidence) -> Iterator[str]:
    """Each one change of the right function that does in every case what the answer does, the likely ones first."""
    if not seen.is_exact:
        return
    begun = time.process_time()
    changes = safely([], one_change_of, seen.right)  # its source may not be at hand
    ranked = sorted(
        ((_rank(kind, said, seen), said, made) for kind, said, made in changes),
        key=lambda one: one[0],
    )
    for rank, said, function in ranked:
        if time.process_time() - begun > SECONDS:
            return
        # one number may be met by chance in so many ways
        is_unlikely = rank >= FAR_FETCHED or _is_read(said, seen)
        is_chance = is_unlikely and len(seen.wrong) == 1
        if rank < NEVER and not is_chance and seen.shows(function, endless=True):
            yield said


@cache
def one_change_of(
    right: Function,
) -> list[tuple[int, str, Function]]:
    """Each function that differs in one thing from `right`, or from a function that it calls; its kind, in words."""
    with warnings.catch_warnings():
        # of a number that is called, as there may be one among them
        warnings.simplefilter("ignore")
        return [*islice(_changed(right), MOST), *islice(_changed_inside(right), MOST)]


def _changed(
    right: Function,
) -> Iterator[tuple[int, str, Function]]:
    source, names = textwrap.dedent(inspect.getsource(right)), parameters(right)
    local, compared = (
        right.__code__.co_varnames,
        [n for n in ast.walk(tree_of(right)) if isinstance(n, ast.Compare)],
    )
    bounded = [
        quoted(node.left)
        for node in compared
        if isinstance(node.comparators[0], ast.Constant)
    ]
    for kind, changes in enumerate(KINDS):
        for said, tree in changed(
            source, local if changes is handed_over else names, changes
        ):
            if changes is put_around and any(part in said for part in bounded):
                continue  # it is rather the bound that is another
            function = safely(None, made, tree, right)
            if function is not None:
                yield kind, said, function


def _changed_inside(
    right: Function,
) -> Iterator[tuple[int, str, Function]]:
    for name in right.__code__.co_names:
        inner = right.__globals__.get(name)
        if isinstance(inner, FunctionType) and inner.__module__ == right.__module__:
            for kind, said, other in _changed(inner):
                yield (
                    kind + 3,
                    said,
                    FunctionType(
                        right.__code__,
                        {**right.__globals__, name: other},
                        right.__name__,
                    ),
                )


def _is_read(said: str, seen: Evidence) -> bool:
    """Whether the answer takes an argument as it is given, of which is said that it were always the same."""
    number = ALWAYS.fullmatch(said)
    if number is None or number[1] not in seen.parameters:
        return False
    given = safely(set(), read_as_given, seen.answer)
    return seen.parameters.index(number[1]) in given


def _rank(kind: int, said: str, seen: Evidence) -> float:
    """How far-fetched a change is; NEVER if it puts a thing of another type in a name's place."""
    number = ALWAYS.fullmatch(said)
    if number:
        types, is_whole = _types(number[1], seen), number[2] in "01"
        if "float" not in types and not (is_whole and types <= {"int", "bool"}):
            return NEVER
        return kind if is_whole and types <= {"float", "bool"} else kind + 1.5
    pair = IN_PLACE.search(said)
    if pair:
        types, others = (_types(name, seen) for name in pair.groups())
        others = {"int", "float"} if pair[2] in (None, pair[1]) else others
        if types and others and types.isdisjoint(others):
            return NEVER
    return (
        kind
        + 2 * (kind == 0)
        + 0.5 * said.startswith("“return")
        + 5 * ("rounded down" in said)
    )


def _types(name: str | None, seen: Evidence) -> set[str]:
    """Which types an argument has in the cases; none for any other name."""
    return {type(case[name]).__name__.strip("_") for case in seen.cases if name in case}


def _in_its_words(said: str, seen: Evidence) -> str:
    """`said` in the names of the answer; empty where it names something that the answer does not have.

    The variables of the right function that the answer lacks are named by what they are set to, or by the variable of
    the answer that is set in the same way.
    """
    right, answer = seen.right, seen.answer
    mine, theirs = (
        names_of(answer),
        (*right.__code__.co_varnames, *right.__code__.co_cellvars),
    )
    code = getattr(answer, "__code__", None)
    more = (*code.co_names, *code.co_cellvars) if code else ()
    known = {
        *dir(builtins),
        *CALLED,
        *REDUCED,
        "np",
        "math",
        *mine,
        *seen.lenders,
        *more,
    }
    called = dict(
        zip(
            parameters(right),
            mine[: code.co_argcount] if code else parameters(right),
            strict=False,
        )
    )
    terms = {
        name: called.get(name, name)
        for name in theirs
        if name in called or name in known
    }
    once = {
        name: value for name, value in _set_once(right).items() if name not in terms
    }
    terms |= safely({}, _set_alike, right, answer, {*terms, *once})
    for name, value in once.items():
        terms[name] = _put(value, terms, known) or name
    number = ALWAYS.fullmatch(said)
    if number and _types(number[1], seen) == {"bool"}:
        said = f"“{number[1]}” were always {number[2] == '1'}"
    pieces = {piece: _put(piece, terms, known) for piece in QUOTED.findall(said)}
    code = safely("", code_of, answer)
    # without the code around it where that is the solution's
    for words in (said, AROUND.sub("", said)):
        quotes = [pieces[piece] for piece in QUOTED.findall(words)]
        if quotes and all(
            may_be_told(piece, code, {*called.values()}) for piece in quotes
        ):
            return QUOTED.sub(lambda piece: f"“{pieces[piece[1]]}”", words)
    return ""


def _put(piece: str, terms: Mapping[str, str], known: set[str]) -> str:
    """A piece of code with other terms for its names; empty if there are names in it that are not known."""
    if piece in ("and", "or"):
        return piece
    word = WORD.fullmatch(piece)
    if word:
        value = _put(word[2], terms, known)
        return word[1] + value if value else ""
    tree: Any = ast.parse(f"{piece} pass" if piece.endswith(":") else piece).body[0]
    if (
        isinstance(tree, ast.Assign)
        and not terms.get(ast.unparse(tree.targets[0]), "_").isidentifier()
    ):
        tree = tree.value
    names = [node for node in ast.walk(tree) if isinstance(node, ast.Name)]
    if any(node.id not in terms and node.id not in known for node in names):
        return ""
    for node in names:
        become(node, terms.get(node.id, node.id))
    return ast.unparse(tree).splitlines()[0]


def _set_alike(right: Function, answer: Function, told: set[str]) -> dict[str, str]:
    """Which variable of the answer is set in the ways in which one of the right function is, if only one is."""
    theirs, mine = (_ways(function, told) for function in (right, answer))
    ways, pairs = [*theirs.values(), *mine.values()], product(theirs, mine)
    return {
        name: other
        for name, other in pairs
        if theirs[name] == mine[other] and ways.count(mine[other]) == 2
    }


def _ways(function: Function, told: set[str]) -> dict[str, set[Any]]:
    """How each variable is set: by which kind of statement, and as which of several."""
    ways: dict[str, set[Any]] = defaultdict(set)
    for node in ast.walk(tree_of(function)):
        for target in getattr(node, "targets", [getattr(node, "target", None)]):
            for k, part in enumerate(getattr(target, "elts", [target])):
                if isinstance(part, ast.Name) and part.id not in told:
                    ways[part.id].add(
                        (
                            k,
                            type(node),
                            part is target or type(getattr(node, "value", None)),
                        )
                    )
    return ways


def _set_once(function: Function) -> dict[str, str]:
    """The variables of a function that are set in one place, and to what."""
    tree = tree_of(function)
    stored = [
        node.id
        for node in ast.walk(tree)
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
    ]
    return {
        node.targets[0].id: ast.unparse(node.value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name)
        # a list or a dict will be filled
        if not isinstance(node.value, ast.List | ast.Dict | ast.Constant)
        if stored.count(node.targets[0].id) == 1
    }
