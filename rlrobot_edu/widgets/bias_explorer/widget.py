"""The program of the explorer's page, its data, and the same page as a widget of a notebook."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import anywidget
import numpy as np
import traitlets

from rlrobot_edu.learning.selections.qbiassr import QBIASSR, compute_bias
from rlrobot_edu.learning.selections.softmax import SR
from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.bias_explorer.marks import marks_of
from rlrobot_edu.widgets.bias_explorer.words import (
    name_text,
    state_text,
    state_words,
    value_text,
    value_words,
)
from rlrobot_edu.widgets.javascript.program import program
from rlrobot_edu.widgets.page_file import read_text

SCRIPTS = (
    "stepper/page/numerals.js",
    "bias_explorer/page/bias.js",
    "bias_explorer/page/explorer.js",
)


@cache
def script() -> str:
    """The program, with the library's kernels."""
    kernels = program(
        {
            "sr": SR.compute_probabilities,
            "qbiassr": QBIASSR.compute_probabilities,
            "compute_bias": compute_bias,
        }
    )
    return "\n".join([*map(read_text, SCRIPTS), f"const kernels = {kernels};"])


def style() -> str:
    """How the page looks."""
    return read_text("bias_explorer/page/style.css")


def about(
    task: Task,
    tables: Mapping[str, np.ndarray],
    scales: Mapping[str, float],
    temperature: float,
) -> dict[str, Any]:
    """The page's data that do not change. Raises ValueError if the task is too large for a page."""
    inputs = [
        {"name": name_text(name), **mark._asdict(), "values": [value_text(each) for each in bins],
         "words": [value_words(each) for each in bins]}
        for (name, mark), variable in zip(marks_of(task).items(), task.inputs, strict=True)
        for bins in [[variable.decode(i) for i in range(variable.n_bins)]]
    ]  # fmt: skip
    states = [
        {"text": state_text(task, s), "words": state_words(task, s), "bins": task.states.bins(s),
         "sets": [members.tolist() for members in task.states.siblings(s).values()]}
        for s in range(task.states.n)
    ]  # fmt: skip
    return {
        "shape": task.states.shape, "inputs": inputs, "states": states,
        "actions": task.actions.labels,
        "temperature": temperature,
        "originals": [{"name": str(name), "q": q.tolist(), "scale": scales[name]} for name, q in tables.items()],
    }  # fmt: skip


class ExplorerWidget(anywidget.AnyWidget):
    """A view of an explorer, which keeps what a reader has chosen and edited.

    about: what does not change; state: the one shown; table: which table is, by its place; tables: values of all
    stage: how many columns the reader sees, 0 (the state's own row alone) to 4
    """

    about, tables = traitlets.Dict().tag(sync=True), traitlets.List().tag(sync=True)
    state, table, stage = (traitlets.Int().tag(sync=True) for _ in range(3))

    def __init__(self, about: dict[str, Any], state: int) -> None:
        self._esm, self._css = script() + "\nexport default { render };", style()
        super().__init__(
            about=about,
            state=state,
            tables=[table["q"] for table in about["originals"]],
        )
