"""Which pieces of code a learner is told who has not asked for a hint: no line of the solution."""

from __future__ import annotations

import ast
import re

from rlrobot_grading.answers.source import tree_of
from rlrobot_grading.answers.values import Function
from rlrobot_grading.hints.further_changes import REDUCED
from rlrobot_grading.hints.simple_changes import CALLED

LONGEST = 90  # characters of a piece of code that is told
SHORT = 25  # of one that the learner has not written
WORD = re.compile(r"(\w+=)([^ =].*)")  # of a call, as in axis=0


def code_of(answer: Function) -> str:
    """The code of an answer in Python's own writing, as pieces of code are told."""
    return ast.unparse(tree_of(answer))


def may_be_told(piece: str, code: str, arguments: set[str]) -> bool:
    """Whether a piece of code is the learner's own, or short and made of the learner's names; no other line is told."""
    if not piece:
        return False
    if re.search(rf"(?<!\w){re.escape(piece)}(?!\w)", code):
        return len(piece) <= LONGEST
    if piece in ("and", "or", "break", "continue") or piece in {*CALLED, *REDUCED}:
        return True
    if len(piece) > SHORT:
        return False
    tree = ast.parse(piece.partition("=")[2] if WORD.fullmatch(piece) else piece)
    if not isinstance(tree.body[0], ast.Expr):
        return False
    names = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    names |= {node.attr for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
    return names <= arguments | set(re.findall(r"\w+", code))
