"""A table that should change in place, and of which the answer makes a new array under the same name."""

from __future__ import annotations

import ast
from typing import Any

import numpy as np

from rlrobot_grading.answers.source import names_of, tree_of
from rlrobot_grading.answers.values import Function, safely
from rlrobot_grading.hints.evidence import Evidence


def not_in_place(seen: Evidence) -> str:
    """``e = …`` where ``e[:] = …`` is needed: said if the answer is right with this one difference."""
    for name, table in seen.memory.items():
        if not isinstance(table, np.ndarray) or name == seen.returns:
            continue
        mine = safely("", _name_of, name, seen)
        cured = safely(None, _written_in_place, seen.answer, mine)
        if cured is None or not _is_right(cured, seen):
            continue
        return (
            f"{mine} = … makes a new array and calls it {mine}; the table that came in stays as it was. Change its "
            f"entries: {mine}[:] = …"
        )
    return ""


def _name_of(name: str, seen: Evidence) -> str:
    """What the answer calls an argument."""
    return names_of(seen.answer)[seen.parameters.index(name)]


def _written_in_place(answer: Any, name: str) -> Function | None:
    """The answer with ``name[:] = …`` wherever it says ``name = …``; None if it never does."""
    tree = tree_of(answer)
    places = [
        node
        for node in ast.walk(tree)
        if isinstance(node, ast.Assign)
        and isinstance(node.targets[0], ast.Name)
        and node.targets[0].id == name
    ]
    if not places:
        return None
    for node in places:
        entries = ast.parse(f"{name}[:] = 0").body[0]
        assert isinstance(entries, ast.Assign)
        node.targets = entries.targets
    made: dict[str, Any] = {}
    exec(ast.unparse(tree), dict(answer.__globals__), made)
    return made[answer.__name__]  # type: ignore[no-any-return]


def _is_right(answer: Function, seen: Evidence) -> bool:
    pairs = zip(seen.cases, seen.expected, strict=True)
    return all(right.equals(seen.outcome(answer, case)) for case, right in pairs)
