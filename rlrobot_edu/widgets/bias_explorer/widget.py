"""The program of the explorer's page, its data, and the same page as a widget of a notebook."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

from rlrobot_edu.jupyter import anywidget, traitlets
from rlrobot_edu.learning.selections.qbiassr import QBIASSR, compute_bias
from rlrobot_edu.learning.selections.softmax import SR
from rlrobot_edu.show.room.tokens import look
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
    "bias_explorer/page/states.js",
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
    programs = [read_text(name) for name in SCRIPTS]
    return "\n".join([*programs, f"const kernels = {kernels};"])


def style() -> str:
    """How the page looks."""
    return look() + read_text("bias_explorer/page/style.css")


def about(
    task: Task,
    tables: Mapping[str, np.ndarray],
    scales: Mapping[str, float],
    temperature: float,
) -> dict[str, Any]:
    """The page's data that do not change. Raises ValueError if the task is too large for a page."""
    inputs = []
    for (name, mark), variable in zip(marks_of(task).items(), task.inputs, strict=True):
        bins = [variable.decode(i) for i in range(variable.n_bins)]
        inputs.append(
            {
                "name": name_text(name),
                "sign": mark.sign,
                "colour": f"var(--{mark.token})",
                "values": [value_text(each) for each in bins],
                "words": [value_words(each) for each in bins],
            }
        )
    originals = []
    for name, q in tables.items():
        originals.append({"name": str(name), "q": q.tolist(), "scale": scales[name]})
    return {
        "shape": task.states.shape,
        "inputs": inputs,
        "states": [_state_data(task, s) for s in range(task.states.n)],
        "actions": task.actions.labels,
        "temperature": temperature,
        "originals": originals,
    }


def _state_data(task: Task, s: int) -> dict[str, Any]:
    """A state in words, and the states of its sets."""
    sets = task.states.siblings(s).values()
    return {
        "text": state_text(task, s),
        "words": state_words(task, s),
        "bins": task.states.bins(s),
        "sets": [states.tolist() for states in sets],
    }


class ExplorerWidget(anywidget.AnyWidget):
    """A view of an explorer, which keeps what a reader has chosen and edited.

    about: what does not change; state: the state shown; table: number of the table shown; tables: values of all tables
    stage: how many columns the reader sees, 0 (the state's own row alone) to 4
    """

    about = traitlets.Dict().tag(sync=True)
    tables = traitlets.List().tag(sync=True)
    state = traitlets.Int().tag(sync=True)
    table = traitlets.Int().tag(sync=True)
    stage = traitlets.Int(4).tag(sync=True)

    def __init__(self, about: dict[str, Any], state: int) -> None:
        self._esm = script() + "\nexport default { render };"
        self._css = style()
        tables = [table["q"] for table in about["originals"]]
        super().__init__(about=about, state=state, tables=tables)
