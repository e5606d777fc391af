"""A page an exercise: task, hints and mistakes stand in Markdown, right function and tape in the lesson's Python file.

`lesson_03/update.md` is the page of ``update``, which `lesson_03/exercises.py` defines:

    # update
    change q[s, a] by α times the TD error
    ## Hints
    1. Only one number of the table changes …
    ## Result
    This is Q-learning, the whole of it.
    ## Names
    - `target` your function of the exercise above: run its cell first
    ## Given
    nothing is changed yet …
    ```python
    def update(q, s, a, r, s_next, terminated, alpha, gamma):
        …
    ```
    ## Mistakes
    - **past_the_end** this looks past the end …
      `terminated` → `False`

What is to be mended has a section ``Given``: the hint for who has not changed it, and the function with its wrong line.
A mistake has its id, its hint in one line, and its edit: text of the right function, and what a learner writes in its
place (``nothing`` for none; ⏎ is the end of a line). Without an edit, the first block of Python below it is the wrong
function. All other blocks are its *witnesses*, wrong answers that must be recognised so. The mistake of a question has
its wrong value, and below maybe witnesses. An id without a hint has witnesses alone: a detector finds their hint.
The line ``- those of `learn` `` adds the mistakes of another page of the lesson, if they are edits.
A question has a section ``Because``: why its answer is right. One whose answer is a number, or several, has a section
``First step``: a sentence or two that are always true, the first step of the way in words and the size or the sign that
the result must have, but no number of it. It is the hint for a wrong answer for which there is no other.
"""

from __future__ import annotations

import ast
import math
import re
import textwrap
from collections import defaultdict
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np

from rlrobot_grading.exercises.exercise import Exercise, Keep, Offer
from rlrobot_grading.exercises.mistake import Mistake
from rlrobot_grading.exercises.question import Question
from rlrobot_grading.exercises.verdict import AS_GIVEN

KNOWN = re.compile(r"- \*\*([\w+]+)\*\* ?(.*)")
NAME = re.compile(r"- `(\w+)` (.+)")
EDIT = re.compile(r"  `(.+?)` → (?:`(.+)`|nothing)")
SHARED = re.compile(r"- those of `(\w+)`")
VALUE = re.compile(r"  `(.+)`")
BEGIN, END = "```python", "```"


class Page(NamedTuple):
    """What stands on a page: its lines by their headings, its mistakes, and the functions given to be mended."""

    sections: dict[str, list[str]]
    entries: list[Entry]
    given: list[Any]


class Entry(NamedTuple):
    """What stands under one id: its hint, edits of the right function, and wrong functions or values."""

    id: str
    hint: str
    edits: dict[str, str]
    answers: list[Any]


def with_pages(
    names: dict[str, Any],
    keep: Keep | None = None,
    offer: Offer | None = None,
    **exercises: Exercise | Question,
) -> SimpleNamespace:
    """The exercises of a lesson, each with its page: ``check.update`` is the one of `update.md`.

    names: the ``globals()`` of the lesson's Python file, beside which the pages lie; wrong answers may use them. The
        right values of questions are added to them
    keep: of each `Exercise`, what is done with a right answer in a notebook
    offer: and what is shown below the verdict on a wrong one
    Raises ValueError for a page that cannot be understood, OSError if one is missing.
    """
    names.update(
        {
            name: one.right
            for name, one in exercises.items()
            if isinstance(one, Question)
        }
    )
    pages = {
        name: Path(names["__file__"]).with_name(f"{name}.md") for name in exercises
    }
    return SimpleNamespace(
        **{
            name: _with_page(exercises[name], page, names, keep, offer)
            for name, page in pages.items()
        }
    )


def _with_page(
    exercise: Any,
    page: Path,
    names: Mapping[str, Any],
    keep: Keep | None,
    offer: Offer | None,
) -> Any:
    sections, entries, given = read_page(page, names)
    text = {heading: " ".join(lines) for heading, lines in sections.items()}
    more: dict[str, Any] = {
        "because": text.get("Because", ""),
        "first_step": text.get("First step", ""),
    }
    if not isinstance(exercise, Question):
        found = [NAME.fullmatch(line) for line in sections["Names"]]
        lenders = {name[1]: name[2] for name in found if name}
        more = {"lenders": lenders, "keep": keep, "offer": offer}
        if given:
            more["given"] = Mistake(text["Given"], given[-1], AS_GIVEN)
    mistakes = [
        Mistake(e.hint, e.edits or e.answers.pop(0), e.id) for e in entries if e.hint
    ]
    return replace(
        exercise,
        name=page.stem,
        task=text[page.stem],
        hints=[line.partition(". ")[2] for line in sections["Hints"]],
        gained=text.get("Result", ""),
        mistakes=[*exercise.mistakes, *mistakes],
        witnesses=_witnesses(entries, given),
        **more,
    )


def _witnesses(entries: list[Entry], given: list[Any]) -> dict[str, list[Any]]:
    witnesses = {entry.id: entry.answers for entry in entries if entry.answers}
    if given:
        witnesses[AS_GIVEN] = given
    return witnesses


def read_page(page: Path, names: Mapping[str, Any]) -> Page:
    """All that stands on a page. Raises ValueError that names what is wrong."""
    names = {"np": np, "math": math} | dict(names)
    sections: dict[str, list[str]] = defaultdict(list)
    entries: list[Entry] = []
    given: list[Any] = []
    section, begin = "", 0
    lines = page.read_text(encoding="utf-8").splitlines()
    for number, line in enumerate(lines, start=1):
        known = KNOWN.fullmatch(line)
        shared = SHARED.fullmatch(line)
        edit = EDIT.fullmatch(line)
        value = VALUE.fullmatch(line)
        if begin:
            if line.strip() == END:
                functions = given if section == "Given" else entries[-1].answers
                functions.append(
                    _last_function(lines[begin : number - 1], begin, page, names)
                )
                begin = 0
        elif line.startswith("#"):
            section = line.lstrip("# ")
        elif section == "Given" and line == BEGIN:
            begin = number
        elif section != "Mistakes":
            sections[section] += [line] if line else []
        elif known:
            entries.append(Entry(known[1], known[2], {}, []))
        elif shared:
            others = read_page(page.with_name(f"{shared[1]}.md"), names)[1]
            entries += [other._replace(answers=[]) for other in others if other.edits]
        elif edit:
            entries[-1].edits[edit[1].replace("⏎", "\n")] = (edit[2] or "").replace(
                "⏎", "\n"
            )
        elif value:
            entries[-1].answers.append(eval(value[1], dict(names)))
        elif line.strip() == BEGIN:
            begin = number
        elif line:
            raise ValueError(
                f"{page}, line {number}: a mistake is told as in rlrobot_grading/exercises/page.py, not by {line!r}"
            )
    if begin:
        raise ValueError(
            f"{page}, line {begin}: this block of Python has no end; close it by three backticks"
        )
    if not sections[page.stem]:
        raise ValueError(
            f"{page} must begin with the line '# {page.stem}' and, below it, the task"
        )
    bare = [entry.id for entry in entries if not entry.edits and not entry.answers]
    if bare:
        raise ValueError(
            f"{page}: below {bare[0]} there must be an edit, a value or a block of Python"
        )
    return Page(sections, entries, given)


def _last_function(
    block: list[str], above: int, page: Path, names: Mapping[str, Any]
) -> Any:
    """What a block of Python defines last; `above`: number of lines above it, so that a traceback finds its own."""
    source = "\n" * above + textwrap.dedent("\n".join(block))
    cell = dict(names)
    exec(compile(source, str(page), "exec"), cell)
    last: Any = ast.parse(source).body[-1]
    return cell[last.targets[0].id if isinstance(last, ast.Assign) else last.name]
