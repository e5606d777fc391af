"""The bias explorer: click a state, and see which states have a say in the choice made there, and how much."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import ipywidgets
import numpy as np

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.picture import Picture
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task
from rlrobot_edu.widgets.bias_explorer.bias import BiasNumbers, bias_numbers
from rlrobot_edu.widgets.bias_explorer.marks import marks_of
from rlrobot_edu.widgets.bias_explorer.member_table import MemberTable
from rlrobot_edu.widgets.bias_explorer.panes import choice_html, formulas_html, legend_html, vector
from rlrobot_edu.widgets.bias_explorer.saved_page import save_states
from rlrobot_edu.widgets.bias_explorer.state_buttons import StateButtons
from rlrobot_edu.widgets.bias_explorer.states import state_words
from rlrobot_edu.widgets.bias_explorer.still import draw_bias


class BiasExplorer(Displayed):
    """All states of a small task as buttons, and beside them the sets, means, bias and probabilities of one state.

    Parameters
    ----------
    task : Task or str
        A task of at most 64 states and 6 inputs, or its name.
    tables : Mapping[str, ndarray or Agent]
        By name, arrays (n_states, n_actions) or trained agents. Their values are copied: edits change the copy.
        What is shown is the paper's bias, whatever selection such an agent has.
    state : int
        The state shown first.
    temperature : float
        Boltzmann temperature > 0.

    Raises
    ------
    ValueError
        If task, tables and state do not fit together.

    References
    ----------
    Paper algorithm 2 and the example below it.
    """

    def __init__(
        self,
        task: Task | str,
        tables: Mapping[str, np.ndarray | Agent],
        state: int = 0,
        temperature: float = 1.0,
    ) -> None:
        self.task = load_task(task)
        self._marks = marks_of(self.task)
        self._originals, self._scales = _read_tables(self.task, tables)
        self._tables = {name: q.copy() for name, q in self._originals.items()}
        self._actions = [self.task.actions.label(a) for a in range(self.task.actions.n)]
        if not 0 < temperature < np.inf:
            raise ValueError(f"temperature must be a finite number above 0, got {temperature!r}")
        self.task.states.bins(state)  # names a state that does not exist
        self.temperature, self.state = temperature, state
        self.widget = self._build()
        self._refresh()

    @property
    def q(self) -> np.ndarray:
        """The Q-table shown, edits included, array (n_states, n_actions)."""
        return self._tables[self.table.value]

    @property
    def numbers(self) -> BiasNumbers:
        """Everything that is shown about the state."""
        return bias_numbers(self.task, self.q, self.state, self._scales[self.table.value], self.temperature)

    def save(self, path: str | Path) -> None:
        """Write one HTML page on which every state can be clicked, without a kernel and without a network.

        Parameters
        ----------
        path : str or Path
            The file, such as ``bias.html``; the address ``bias.html#17`` leads to state 17,
            and ``bias.html#17-2`` to state 17 of the second table.

        Notes
        -----
        The page shows all tables as they are now, edits included; on the page itself Q cannot be edited.
        """
        save_states(path, self.task, self._tables, self._scales, self._marks, self._actions, self.state,
                    self.temperature)  # fmt: skip

    def picture(self) -> Picture:
        """The still twin: states and their marks, the means, and the probabilities.

        Returns
        -------
        Picture
            A matplotlib figure with a description in words.
        """
        return draw_bias(self.task, self.q, self.numbers, self._marks, self._actions)

    def still(self) -> Still:
        """The picture, as a saved notebook keeps it.

        Returns
        -------
        Still
            The picture and its description.
        """
        return self.picture().still()

    def _build(self) -> ipywidgets.Widget:
        compact = {"style": {"description_width": "initial"}, "layout": {"width": "17em"}}
        self.table = ipywidgets.Dropdown(options=list(self._tables), description="Q-table", **compact)
        self.table.observe(lambda _: self._refresh(), "value")
        self.reset = ipywidgets.Button(description="Reset Q", tooltip="Undo all edits of this Q-table")
        self.reset.layout.width = "6em"
        self.reset.on_click(lambda _: self._undo())
        self.inputs = [self._input(i) for i in range(len(self.task.inputs))]
        self.states = StateButtons(self.task, self._marks, self._choose)
        self.members = MemberTable(self.task, self._marks, self._actions, self._edit)
        self._legend, self._formulas, self._choice = (ipywidgets.HTML() for _ in range(3))
        titles = ("The state: click one, or choose its inputs", "Q of the states that have a say: edit it")
        chosen_by, edit_here = (ipywidgets.HTML(f"<b>{title}</b>") for title in titles)
        wrap = {"flex_flow": "row wrap"}
        chosen = ipywidgets.Box(self.inputs, layout=wrap)
        left = ipywidgets.VBox([chosen_by, self.states.widget, chosen, self._legend])
        left.layout = {"width": "min-content", "margin": "0 10px 0 0"}  # as wide as the states: the text is to wrap
        right = ipywidgets.VBox([edit_here, ipywidgets.HBox([self.table, self.reset]), self.members.widget])
        # what a click does stands beside the states on any page; where there is no room, the table goes below
        top = ipywidgets.Box([left, self._choice, right], layout={**wrap, "align_items": "flex-start"})
        return ipywidgets.VBox([top, self._formulas])

    def _input(self, i: int) -> ipywidgets.Dropdown:
        """The list of an input's values, with its mark."""
        variable = self.task.inputs[i]
        options = [(str(variable.decode(k)).replace("-", "−"), k) for k in range(variable.n_bins)]
        dropdown = ipywidgets.Dropdown(
            options=options, description=f"{self._marks[variable.name].sign} {variable.name}", layout={"width": "auto"},
            style={"description_width": "initial"},
        )  # fmt: skip
        dropdown.observe(lambda change: self._set_input(i, change["new"]), "value")
        return dropdown

    def _set_input(self, i: int, value: int) -> None:
        bins = list(self.task.states.bins(self.state))
        if bins[i] != value:  # else it is we who brought the list in line with the state
            bins[i] = value
            self._choose(self.task.states.number(bins))

    def _choose(self, state: int) -> None:
        self.state = state
        self._refresh()

    def _edit(self, s: int, a: int, value: float) -> None:
        if np.isfinite(value):
            self.q[s, a] = value
        self._refresh()

    def _undo(self) -> None:
        self.q[...] = self._originals[self.table.value]
        self._refresh()

    def _refresh(self) -> None:
        """Bring everything on the page in line with the table and the state."""
        numbers = self.numbers
        for dropdown, value in zip(self.inputs, self.task.states.bins(self.state), strict=True):
            dropdown.value = value
        self.states.update(numbers)
        self.members.update(numbers, self.q)
        self._legend.value = legend_html(self._marks, self.state)
        self._formulas.value = formulas_html(self.task, self.q, numbers, self._marks, self._actions)
        self._choice.value = choice_html(numbers, self._actions, self._scales[self.table.value], self.temperature)

    def __repr__(self) -> str:
        where = f"state {self.state} ({state_words(self.task, self.state)})"
        return f"<BiasExplorer of {self.task.name}, {self.table.value}, {where}: bias {vector(self.numbers.bias)}>"


def _read_tables(
    task: Task, tables: Mapping[str, np.ndarray | Agent]
) -> tuple[dict[str, np.ndarray], dict[str, float]]:
    """By name, a copy of each table's values and the factor that normalises it. Raises ValueError if one is wrong."""
    if not isinstance(tables, Mapping) or not tables:
        raise ValueError("the bias explorer needs at least one Q-table, such as tables={'my agent': agent}")
    values, scales = {}, {}
    size = (task.states.n, task.actions.n)
    for name, table in tables.items():
        agent = table if isinstance(table, Agent) else Agent(task)  # an array is normalised with an agent's defaults
        q = np.array(table.q if table is agent else table, dtype=float)
        if q.shape != size or not np.isfinite(q).all():
            raise ValueError(
                f"Q-table {name!r} must hold finite numbers, one row for each of the {size[0]} states and one column "
                f"for each of the {size[1]} actions of {task.name}; got an array of shape {q.shape}"
            )
        values[name], scales[name] = q, agent.parameters.q_scale
    return values, scales
