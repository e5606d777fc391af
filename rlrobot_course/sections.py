"""The text of `my_functions.py`: a section for each function, under the line `# lesson 02: target`.

A section has what the function needs, too. All between the sections and in them may be the learner's, and only the
lines of the one function are ever replaced.
"""

import ast
import io
import re
from collections.abc import Callable
from typing import NamedTuple

HEAD = '''"""My functions. The check of its lesson has found each of them right."""

import math

import numpy as np
'''
LESSON = re.compile(r"(?:\A|(?<=[\r\n]))# lesson (\w+): (\w+)[ \t]*(?:\r\n|\r|\n|\Z)")
NOT_KEPT = "# not kept: "  # the reason follows

Key = tuple[str, str]  # lesson and name of a function


class Section(NamedTuple):
    """Where a section is in the text: `line` is where its first line begins; its body is text[begin:end]."""

    key: Key
    line: int
    begin: int
    end: int


def sections(text: str) -> list[Section]:
    """The sections of a text, in their order."""
    found = list(LESSON.finditer(text))
    ends = [match.start() for match in found[1:]] + [len(text)]
    return [Section((m[1], m[2]), m.start(), m.end(), end) for m, end in zip(found, ends, strict=False)]


def sources(text: str) -> dict[Key, str]:
    """By lesson and name, what stands in each section; of two of the same name, in the later one."""
    return {section.key: text[section.begin : section.end].strip("\r\n") + "\n" for section in sections(text)}


def with_source(text: str, key: Key, source: str, works: Callable[[str], bool]) -> tuple[str, bool]:
    """The text with `source` in the section of `key`, and whether all else is still in it.

    works: whether the function that a section defines is right; where it is not, what else is in the section is at
        fault or cannot be read, and `source` takes the place of the whole section
    """
    text = text or HEAD
    new_line = re.search(r"\r\n|\r|\n|\Z", text)[0] or "\n"  # type: ignore[index]
    source = source.replace("\n", new_line)
    text += new_line * (not text.endswith(("\r", "\n")))
    known = sections(text)
    place = next((section for section in reversed(known) if section.key == key), None)
    if place is None:
        whole = f"# lesson {key[0]}: {key[1]}{new_line}{source}"
        at = next((section.line for section in known if section.key > key), len(text))
        if at < len(text):
            return text[:at] + whole + 2 * new_line + text[at:], True
        return text + 2 * new_line + whole, True
    body = text[place.begin : place.end]
    is_last = place.end == len(text)
    changed = _changed(body, key[1], source, new_line)
    if changed is None or not (changed.strip() == source.strip() or works(changed)):
        return text[: place.begin] + source + 2 * new_line * (not is_last) + text[place.end :], False
    return text[: place.begin] + changed + text[place.end :], True


def _changed(body: str, name: str, source: str, new_line: str) -> str | None:
    """The body of a section with the function `name` as in `source`; None where it cannot be told what is what.

    What the function needs goes in front of it, if it is not in the section already.
    """
    body = re.sub(rf"\A{NOT_KEPT}[^\r\n]*(?:\r\n|\r|\n|\Z)", "", body)
    try:
        old, new = ast.parse(body).body, ast.parse(source).body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    lines, new_lines = _lines(body), _lines(source)
    there = {ast.dump(statement) for statement in old}
    own = {name, getattr(getattr(new[-1], "value", None), "id", name)}  # of target = goal both
    places = {_binds(statement): statement for statement in old if _binds(statement) in own}
    needed: list[str] = []
    for statement in new:
        text = new_lines[statement.lineno - 1 : statement.end_lineno]
        if place := places.get(_binds(statement)):
            if _shares_a_line(place, lines):
                return None
            # all in the first of the lines, so that the others keep their numbers
            lines[_first(place) : place.end_lineno] = ["".join(text), *[""] * (place.end_lineno - _first(place) - 1)]
        elif ast.dump(statement) not in there:
            needed += [*text, *[2 * new_line] * isinstance(statement, ast.FunctionDef)]
    at = min(map(_first, places.values()), default=0)
    if not places and body.strip() == "":
        needed = new_lines
    return "".join(lines[:at] + needed + lines[at:])


def _lines(text: str) -> list[str]:
    """The lines of a text, with their ends, as Python counts them."""
    return io.StringIO(text, newline="").readlines()


def _binds(statement: ast.stmt) -> str:
    """The name that a definition or an assignment gives a value; empty for any other statement."""
    if isinstance(statement, ast.FunctionDef):
        return statement.name
    if isinstance(statement, ast.Assign) and isinstance(statement.targets[0], ast.Name):
        return statement.targets[0].id
    return ""


def _first(statement: ast.stmt) -> int:
    """The number of a statement's first line, from 0, with its decorators."""
    return min([statement.lineno, *(one.lineno for one in getattr(statement, "decorator_list", []))]) - 1


def _shares_a_line(statement: ast.stmt, lines: list[str]) -> bool:
    """Whether more stands in the lines of a statement; a comment at the end of a function is the function's."""
    after = lines[statement.end_lineno - 1].encode()[statement.end_col_offset :].strip()
    return statement.col_offset > 0 or (bool(after) and not isinstance(statement, ast.FunctionDef))
