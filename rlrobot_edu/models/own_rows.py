"""Rows of your own become the transitions of a task.

A row is a transition and holds the state after the step; or it is a step, and the next row holds that state.
"""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.checks import did_you_mean
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.data_package import count_episodes
from rlrobot_edu.models.source import Source
from rlrobot_edu.models.tables import ORDER, Table, in_numbers
from rlrobot_edu.task.task import Task

FLAGS = ("terminated", "truncated")
COUNTERS = ("episode", "step")


def transitions_of(table: Table, task: Task) -> Transitions:
    """The rows as transitions of `task`. Raises ValueError in one sentence for the first that cannot be one."""
    state = _chosen(table, "s", [variable.name for variable in task.inputs])
    action = _chosen(table, "a", [variable.name for variable in task.outputs])
    after = [f"{name}_next" for name in state]
    has_next = any(name in table.columns for name in after)
    needed = [*state, *action, "r"]
    if has_next:
        needed += after
    _check_names(table, task, needed, after)
    if len(table.columns["r"]) == 0:
        raise ValueError(f"{table.name}: there are no rows, expected one or more")

    rows = in_numbers(table)
    for name in FLAGS:
        flags = rows.columns.get(name, np.zeros(len(rows.columns["r"])))
        rows.columns[name] = np.where(np.isnan(flags), 0.0, flags)
    if not has_next:
        rows = _with_next_states(rows, state, action)
    _check_filled(rows, rows.columns)

    numbers = {
        "s": _states(rows, state, task),
        "a": _actions(rows, action, task),
        "r": rows.columns["r"],
        "s_next": _states(rows, after, task),
    }
    for name in (*FLAGS, *COUNTERS):
        if name in rows.columns:
            numbers[name] = rows.columns[name]
    remedy = f"correct it, or is it a row of another task than {task.name}?"
    Source.of_task(task).check_rows(numbers, rows.where, remedy)
    return _in_episodes(numbers, rows)


def _in_episodes(numbers: dict[str, NDArray[Any]], rows: Table) -> Transitions:
    """The transitions: an episode that did not terminate before the next began was truncated."""
    is_cut = numbers["s_next"][:-1] != numbers["s"][1:]
    if "episode" in numbers:
        is_cut = np.diff(numbers["episode"]) != 0
    terminated = numbers["terminated"] == 1
    truncated = numbers["truncated"] == 1
    truncated[:-1] |= is_cut & ~terminated[:-1]
    numbers["terminated"] = terminated
    numbers["truncated"] = truncated
    transitions = Transitions(**{name: numbers[name] for name in ORDER})
    step_due = count_episodes(transitions)[1]
    step = numbers.get("step", step_due)
    bad = step != step_due
    if bad.any():
        row = int(np.argmax(bad))
        fault = f"step is {step[row]:g}, expected {step_due[row]}"
        advice = "put missing or moved rows back, or leave out the column step"
        raise ValueError(f"{rows.where(row)}: {fault}; {advice}")
    return transitions


def _chosen(table: Table, number: str, variables: list[str]) -> list[str]:
    """The columns that hold states or actions: their `number`, or a value of each of the task's variables."""
    has_variables = any(name in table.columns for name in variables)
    return variables if has_variables and number not in table.columns else [number]


def _check_names(
    table: Table, task: Task, needed: Sequence[str], after: Sequence[str]
) -> None:
    """Raises ValueError if a column is missing, or is not known: it may be a flag under another name."""
    missing = [name for name in needed if name not in table.columns]
    if missing:
        inputs = ", ".join(variable.name for variable in task.inputs)
        outputs = ", ".join(variable.name for variable in task.outputs)
        found = ", ".join(table.columns)
        expected = f"the state (s, or {inputs}), the action (a, or {outputs}) and the reward (r)"
        raise ValueError(
            f"{table.name}: there is no column {missing[0]}, only {found!r:.200}; expected are {expected}"
        )
    known = dict.fromkeys([*needed, *after, *COUNTERS, *FLAGS])
    unknown = [name for name in table.columns if name not in known]
    if unknown:
        nearest = did_you_mean(unknown[0], known)
        raise ValueError(
            f"{table.name}: there is no use for column {unknown[0]!r:.100}{nearest} Leave it out, "
            f"or rename it to one of {', '.join(known)}"
        )


def _refuse(rows: Table, is_wrong: NDArray[np.bool_], fault: str) -> None:
    """Raises ValueError for the first wrong row, if there is one."""
    if is_wrong.any():
        raise ValueError(f"{rows.where(int(np.argmax(is_wrong)))}: {fault}")


def _check_filled(rows: Table, names: Iterable[str]) -> None:
    for name in names:
        fault = f"{name} is empty, expected a number; fill it in"
        _refuse(rows, np.isnan(rows.columns[name]), fault)


def _with_next_states(
    rows: Table, state: Sequence[str], action: Sequence[str]
) -> Table:
    """Rows of steps as rows of transitions: the state after a step is that of the next row.

    A row without action and reward holds the state in which an episode ended; it is no step itself.
    """
    columns = rows.columns
    acting = [*action, "r"]
    _check_filled(rows, [name for name in columns if name not in acting])
    is_end: Any = np.isnan([columns[name] for name in acting]).all(axis=0)
    has_flag = (columns["terminated"] != 0) | (columns["truncated"] != 0)
    goes_on = is_end[1:] | ~has_flag[:-1]
    if "episode" in columns:
        goes_on = goes_on & (np.diff(columns["episode"]) == 0)
    fault = "the state after this step is missing, expected in the next row"
    advice = "add a row with this state, its action and reward empty"
    _refuse(rows, ~is_end & ~np.append(goes_on, False), f"{fault}; {advice}")
    fault = "without action and reward it is no step, so it cannot end the episode"
    _refuse(rows, is_end & has_flag, f"{fault}; mark the row before it")
    if is_end.all():
        raise ValueError(
            f"{rows.name}: all actions and rewards are empty; fill them in"
        )

    for name in state:
        columns[f"{name}_next"] = np.append(columns[name][1:], np.nan)
    columns["episode"] = np.append(0, np.cumsum(is_end)[:-1])
    steps = np.flatnonzero(~is_end)
    columns = {name: column[steps] for name, column in columns.items()}
    return Table(columns, rows.name, lambda step: rows.where(int(steps[step])))


def _states(rows: Table, names: Sequence[str], task: Task) -> Any:
    """The number of each row's state. Raises ValueError for a reading that an input cannot have."""
    if len(names) == 1 and names[0] in ("s", "s_next"):
        return rows.columns[names[0]]
    places = []
    for variable, name in zip(task.inputs, names, strict=True):
        bins = []
        for row, reading in enumerate(rows.columns[name]):
            try:
                bins.append(variable.bin(reading))
            except ValueError as error:
                place = f"{rows.where(row)}, column {name}"
                raise ValueError(f"{place}: {error}") from None
        places.append(bins)
    return np.ravel_multi_index(places, task.states.shape)


def _actions(rows: Table, names: Sequence[str], task: Task) -> Any:
    """The number of each row's action. Raises ValueError for a value that an output cannot have."""
    if names == ["a"]:
        return rows.columns["a"]
    places = []
    for output in task.outputs:
        column = rows.columns[output.name]
        is_known = np.isin(column, output.values)
        if not is_known.all():
            row = int(np.argmin(is_known))
            expected = f"one of {list(output.values)!s:.200} {output.unit}".rstrip()
            raise ValueError(
                f"{rows.where(row)}: {output.name} is {column[row]:g}, expected {expected}; correct it"
            )
        places.append([output.values.index(value) for value in column])
    return np.ravel_multi_index(places, task.actions.shape)
