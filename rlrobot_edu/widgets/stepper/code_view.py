"""The source of the update that an agent uses, as in the library."""

from __future__ import annotations

import ast
import html
import inspect
import textwrap
from functools import cache
from typing import Any

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.algorithm import Algorithm
from rlrobot_edu.learning.traces import pass_on


def code_html(agent: Agent) -> tuple[str, str]:
    """Where the update of `agent` is, and its lines in HTML, with those of its traces. ▶ marks a change of Q."""
    return _code(agent.method.algorithm)


@cache
def _code(algorithm: Algorithm) -> tuple[str, str]:
    where, rows = _rows(algorithm.update)
    if algorithm.has_traces:
        place, more = _rows(pass_on)
        rows += [f"<div><s></s> <i># pass_on: {place}</i></div>", *more]
    return where, "".join(rows)


def _rows(kernel: Any) -> tuple[str, list[str]]:
    """Where a kernel is, and a row for each line of it."""
    kernel = getattr(kernel, "py_func", kernel)  # numba wraps the function
    lines, first = inspect.getsourcelines(kernel)
    body = ast.parse(textwrap.dedent("".join(lines))).body[0].body
    skip = body[0].end_lineno  # the docstring
    rows = []
    for i, line in enumerate(lines[skip:], start=first + skip):
        changes_q = line.lstrip().startswith("q[")
        if line.strip():
            mark = "▶" if changes_q else ""
            text = html.escape(line.removeprefix("    ").rstrip())
            rows.append(
                f'<div class="{"hot" if changes_q else ""}"><b>{mark}</b><s>{i:>3}</s> {text}</div>'
            )
    return f"{kernel.__module__.replace('.', '/')}.py, line {first + skip}", rows
