"""Which one change of the right function makes it do what an answer does, told in the names of the answer."""

from __future__ import annotations

import ast
import builtins
import inspect
import re
import textwrap
import warnings
from collections.abc import Callable, Iterator
from functools import cache
from itertools import islice
from keyword import kwlist
from types import FunctionType
from typing import Any

import numpy as np

from rlrobot_course.grading.evidence import Evidence
from rlrobot_course.grading.further_changes import changes_everywhere, further_changes, handed_over, put_around
from rlrobot_course.grading.one_change import LONGEST, changed, made, simple_changes
from rlrobot_course.grading.source import names_of, parameters
from rlrobot_course.grading.values import safely

MOST = 1000  # changes that are tried, the simple ones first
QUOTED = re.compile(r"“([^”]*)”")
NAME = re.compile(r"(?<![\w.\"'])[^\W\d]\w*")  # but not what stands behind a point


def one_change(seen: Evidence) -> str:
    """What differs in one thing from the right function and does in every case what the answer does."""
    if not seen.exercise.is_exact:
        return ""
    for said, function in safely([], one_change_of, seen.exercise.right):  # its source may not be at hand
        if seen.shows(function, endless=True) and (told := safely("", _in_its_words, said, seen)):
            return f"it answers as if {told}."
    return ""


@cache
def one_change_of(right: Callable[..., Any]) -> list[tuple[str, Callable[..., Any]]]:
    """Each function that differs in one thing from `right`, or from a function of the course that it calls."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of a number that is called, as there may be one among them
        return [*islice(_changed(right), MOST), *islice(_changed_inside(right), MOST)]


def _changed(right: Callable[..., Any]) -> Iterator[tuple[str, Callable[..., Any]]]:
    source, names = textwrap.dedent(inspect.getsource(right)), parameters(right)
    local = right.__code__.co_varnames
    for changes in (changes_everywhere, simple_changes, further_changes, handed_over, put_around):
        for said, tree in changed(source, local if changes is handed_over else names, changes):
            if (function := safely(None, made, tree, right)) is not None:
                yield said, function


def _changed_inside(right: Callable[..., Any]) -> Iterator[tuple[str, Callable[..., Any]]]:
    for name in right.__code__.co_names:
        inner = right.__globals__.get(name)
        if isinstance(inner, FunctionType) and inner.__module__ == right.__module__:
            for said, other in _changed(inner):
                yield said, FunctionType(right.__code__, {**right.__globals__, name: other}, right.__name__)


def _in_its_words(said: str, seen: Evidence) -> str:
    """`said` in the names of the answer; empty where it names something that the answer does not have.

    The variables of the right function that the answer lacks are told by what they are set to.
    """
    right, answer = seen.exercise.right, seen.answer
    mine, theirs = names_of(answer), (*right.__code__.co_varnames, *right.__code__.co_cellvars)
    code = getattr(answer, "__code__", None)
    more = (*code.co_names, *code.co_cellvars) if code else ()
    known = {*dir(builtins), *kwlist, "np", "math", *mine, *seen.exercise.lenders, *more}
    called = dict(zip(parameters(right), mine[: code.co_argcount] if code else parameters(right), strict=False))
    terms = {name: called.get(name, name) for name in theirs if name in called or name in known}
    for name, value in _set_once(right).items():
        if name not in terms and len(value) <= LONGEST:
            terms[name] = NAME.sub(lambda m: terms.get(m[0], m[0]), value)
    number = re.fullmatch("“(.*)” were always ([01])", said)
    if number and isinstance(seen.exercise.cases[0].get(number[1]), bool | np.bool_):
        said = f"“{number[1]}” were always {number[2] == '1'}"
    told = QUOTED.sub(lambda piece: NAME.sub(lambda m: terms.get(m[0], m[0]), piece[0]), said)
    named = {name for piece in QUOTED.findall(said) for name in NAME.findall(piece)}
    return told if named <= known | terms.keys() else ""


def _set_once(function: Callable[..., Any]) -> dict[str, str]:
    """The variables of a function that are set in one place, and to what."""
    tree = ast.parse(textwrap.dedent(inspect.getsource(function)))
    stored = [node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)]
    return {
        node.targets[0].id: ast.unparse(node.value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name)
        if stored.count(node.targets[0].id) == 1
    }
