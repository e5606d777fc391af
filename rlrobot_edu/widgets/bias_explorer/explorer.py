"""The bias explorer: which states influence a choice of QBIASSR, and how much, in four columns."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from rlrobot_edu.files import write_whole
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.parameters import Parameters
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.picture import Picture
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task
from rlrobot_edu.widgets.bias_explorer.bias import BiasNumbers, bias_numbers
from rlrobot_edu.widgets.bias_explorer.marks import marks_of
from rlrobot_edu.widgets.bias_explorer.still import draw_bias
from rlrobot_edu.widgets.bias_explorer.widget import (
    ExplorerWidget,
    about,
    script,
    style,
)
from rlrobot_edu.widgets.bias_explorer.words import state_words, vector
from rlrobot_edu.widgets.page_file import page_html

TITLE = "How similar states advise a robot in its next choice"
DESCRIPTION = (
    "A robot that hardly knows a state takes the mean of what it learned in similar ones. See which states these are, "
    "change their values, and see how the choice changes."
)
PAPER_STATE = {"X": 1, "Y": 1, "theta": 90, "d": 1}  # below algorithm 2


@suggests_keywords
class BiasExplorer(Displayed):
    """One state of a small task in four columns: values, means of the sets, bias and probabilities; choose and edit.

    It opens with the action whose probability the bias changes most: a sentence in large type, and its four columns. Of
    each other action it shows bias and probabilities; a click opens its columns. A reader builds the columns up with a
    button or the keys ← and →.

    Parameters
    ----------
    task : Task or str
        A task of at most 64 states and 6 inputs, or its name.
    tables : Mapping[str, ndarray or Agent]
        By name, arrays (n_states, n_actions) or trained agents. Their values are copied: edits change the copy.
        What is shown is the paper's bias, whatever selection such an agent has.
    state : int, optional
        The state shown first; without one it is the paper's example, (X, Y, θ, d) = (1, 1, 90°, 1), in a task with
        these inputs, else state 0.

    Raises
    ------
    ValueError
        If task, tables and state do not fit together.
    FileNotFoundError
        If there is no such task file.

    References
    ----------
    Paper algorithm 2 and the example below it.
    """

    def __init__(
        self,
        task: Task | str,
        tables: Mapping[str, np.ndarray | Agent],
        state: int | None = None,
    ) -> None:
        self.task = load_task(task)
        marks_of(self.task)  # raises ValueError for a task that is too large
        if state is None:
            state = _first_state(self.task)
        values, self._scales = _read_tables(self.task, tables)
        self.task.states.bins(state)  # raises ValueError if there is no such state
        data = about(self.task, values, self._scales, Parameters.temperature)
        self.widget = ExplorerWidget(data, int(state))

    @property
    def state(self) -> int:
        """The state shown."""
        return self.widget.state

    @property
    def table(self) -> str:
        """Name of the Q-table shown."""
        names = list(self._scales)
        return names[self.widget.table]

    @property
    def q(self) -> np.ndarray:
        """The Q-table shown, edits included: a copy, array (n_states, n_actions)."""
        table = self.widget.tables[self.widget.table]
        return np.array(table, dtype=float)  # a browser writes 5.0 as 5

    @property
    def numbers(self) -> BiasNumbers:
        """Everything that is shown about the state."""
        scale = self._scales[self.table]
        return bias_numbers(
            self.task, self.q, self.state, scale, Parameters.temperature
        )

    def save(self, path: str | Path) -> None:
        """Write the explorer to one HTML page, which works without a kernel and without a network.

        Parameters
        ----------
        path : str or Path
            The file, such as ``bias.html``; the address ``bias.html#17`` leads to state 17,
            and ``bias.html#17-2`` to state 17 of the second table.

        Raises
        ------
        ValueError
            If the file's name ends like that of another kind of file.
        OSError
            If the file cannot be written.

        Notes
        -----
        The page begins with all tables as they are now, edits included. *Reset Q* undoes them there as well.
        """
        feed = {
            name: getattr(self.widget, name)
            for name in ("about", "state", "table", "tables", "stage")
        }
        page = page_html(TITLE, DESCRIPTION, feed, script(), style())
        write_whole(path, page)

    def picture(self, stage: int = 4) -> Picture:
        """The four columns as a picture, or the first of them.

        Parameters
        ----------
        stage : int
            How many columns of the action whose probability the bias changes most: 1 the values, 2 and the means, 3
            and the bias; 4 all columns, and the choice among all actions.

        Returns
        -------
        Picture
            A matplotlib figure with a description in words.

        Raises
        ------
        ValueError
            If there is no such stage.
        """
        if stage not in range(1, 5):
            raise ValueError(f"stage must be 1, 2, 3 or 4, got {stage!r:.200}")
        return draw_bias(self.task, self.q, self.numbers, marks_of(self.task), stage)

    def still(self) -> Still:
        """The picture, as a saved notebook keeps it.

        Returns
        -------
        Still
            The picture and its description.
        """
        return self.picture().still()

    def __repr__(self) -> str:
        where = f"state {self.state} ({state_words(self.task, self.state)})"
        return f"<BiasExplorer of {self.task.name}, {self.table}, {where}: bias {vector(self.numbers.bias)}>"


def _first_state(task: Task) -> int:
    """The state of the paper's example, or 0 in a task with other inputs."""
    if {variable.name for variable in task.inputs} != PAPER_STATE.keys():
        return 0
    return task.states.encode(PAPER_STATE)


def _read_tables(
    task: Task, tables: Mapping[str, np.ndarray | Agent]
) -> tuple[dict[str, np.ndarray], dict[str, float]]:
    """By name, a copy of each table's values and the factor that normalises it. Raises ValueError if one is wrong."""
    if not isinstance(tables, Mapping) or not tables:
        raise ValueError(
            "the bias explorer needs at least one Q-table, such as tables={'my agent': agent}"
        )
    values, scales = {}, {}
    size = (task.states.n, task.actions.n)
    for name, table in tables.items():
        if isinstance(table, Agent):
            agent = table
            q = np.array(table.q, dtype=float)
        else:
            agent = Agent(task)  # an array is normalised with its defaults
            q = np.array(table, dtype=float)
        if q.shape != size or not np.isfinite(q).all():
            raise ValueError(
                f"Q-table {name!r} must hold finite numbers, one row for each of the {size[0]} states and one column "
                f"for each of the {size[1]} actions of {task.name}; got an array of shape {q.shape}"
            )
        values[name] = q
        scales[name] = float(agent.parameters.q_scale)
    return values, scales
