"""The states that have a say in the bias, with their values to edit."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from html import escape

import ipywidgets
import numpy as np

from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.bias_explorer.bias import BiasNumbers
from rlrobot_edu.widgets.bias_explorer.marks import HERE, Mark
from rlrobot_edu.widgets.bias_explorer.panes import chip
from rlrobot_edu.widgets.bias_explorer.states import inputs_text, state_text


class MemberTable:
    """A row for each member of the sets, the state itself first, and a field for each action.

    marks: of each input, by name; actions: their names
    edit: called with state, action and value when the reader has changed a field
    """

    def __init__(
        self, task: Task, marks: dict[str, Mark], actions: Sequence[str], edit: Callable[[int, int, float], None]
    ) -> None:
        self._task, self._marks, self._actions, self._edit = task, marks, actions, edit
        self._states: list[int] = []  # of the rows; empty while we write into the fields ourselves
        n_rows = 1 + sum(n - 1 for n in task.states.shape)
        self._names = [ipywidgets.HTML() for _ in range(n_rows)]
        self.fields = [[self._field(row, a) for a in range(len(actions))] for row in range(n_rows)]
        cells = [
            ipywidgets.HTML(f"state {escape(inputs_text(task))}"),
            *(ipywidgets.HTML(f"&nbsp; {escape(name)}") for name in actions),
        ]
        for name, fields in zip(self._names, self.fields, strict=True):
            cells.extend([name, *fields])
        columns = f"auto repeat({len(actions)}, 77px)"
        self.widget = ipywidgets.GridBox(cells, layout={"grid_template_columns": columns, "grid_gap": "0 2px"})

    def update(self, numbers: BiasNumbers, q: np.ndarray) -> None:
        """Show the members of the sets in `numbers`, and their values in `q`, array (n_states, n_actions)."""
        self._states = []
        for (s, name), label, fields in zip(numbers.members, self._names, self.fields, strict=True):
            who = chip(HERE, str(s)) if name is None else chip(self._marks[name], str(s))
            label.value = f'<span style="white-space:nowrap">{who}{escape(state_text(self._task, s))}</span>'
            for a, field in enumerate(fields):
                with field.hold_sync():  # one message to the browser instead of two
                    field.value, field.description = round(float(q[s, a]), 3), f"Q of state {s}, {self._actions[a]}"
        self._states = [s for s, _ in numbers.members]

    def _field(self, row: int, a: int) -> ipywidgets.FloatText:
        # the description takes no room: it is there to be read aloud
        field = ipywidgets.FloatText(layout={"width": "auto", "margin": "1px"}, style={"description_width": "0"})
        field.observe(lambda change: self._states and self._edit(self._states[row], a, change["new"]), "value")
        return field
