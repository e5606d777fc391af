"""Answers as learners write them: they stand as Python in a Markdown file beside their exercise, `update.md`.

Under ``## Changed`` stand the mistakes in which whole lines of the solution change, under ``## Witnesses`` the wrong
answers that a check must recognise. Each block has the id of its mistake as a heading: ``### past_the_end``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

Answers = dict[str, list[Callable[..., Any]]]  # by id


def read_answers(exercise_file: str, names: Mapping[str, Any]) -> tuple[dict[str, Callable[..., Any]], Answers]:
    """The changed functions and the witnesses, by their ids.

    exercise_file: beside which the Markdown file lies; names: that the answers may use, as those of the exercise's file
    Raises OSError if there is no such file.
    """
    file = Path(exercise_file).with_suffix(".md")
    sections: dict[str, Answers] = {"Changed": {}, "Witnesses": {}}
    section, known, begin = sections["Witnesses"], "", -1
    lines = file.read_text(encoding="utf-8").splitlines(keepends=True)
    for number, line in enumerate(lines):
        if line.startswith("## "):
            section = sections[line[3:].strip()]
        elif line.startswith("### "):
            known = line[4:].strip()
        elif line.startswith("```python"):
            begin = number + 1
        elif line.startswith("```"):
            source = "\n" * begin + "".join(lines[begin:number])  # so a traceback finds the line in the file
            section.setdefault(known, []).append(_last_function(source, file, names))
    return {known: functions[0] for known, functions in sections["Changed"].items()}, sections["Witnesses"]


def _last_function(source: str, file: Path, names: Mapping[str, Any]) -> Callable[..., Any]:
    cell = {"np": np} | dict(names)
    before = set(cell)
    exec(compile(source, str(file), "exec"), cell)
    made = [thing for name, thing in cell.items() if name not in before and callable(thing)]
    return made[-1]  # type: ignore[no-any-return]
