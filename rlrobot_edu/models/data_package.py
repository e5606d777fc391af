"""The one format of recordings: transitions.csv and datapackage.json, written, and refused if not whole and right.

Together they are a Frictionless data package, version 1 (https://specs.frictionlessdata.io). Any tool that
knows data packages can read the columns; the section "rlrobot" says what the numbers mean. It holds no time
and no path, so the same recording is described by the same bytes.
"""

import json
import math
import re
import warnings
from dataclasses import asdict
from pathlib import Path
from types import UnionType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.checks import check_numbers
from rlrobot_edu.files import sha256
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.source import REMEDY, Source
from rlrobot_edu.task.room import Room
from rlrobot_edu.task.spaces import ActionSpace, StateSpace
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import available_tasks, load_task
from rlrobot_edu.task.variables import InputVariable, OutputVariable

CSV_NAME = "transitions.csv"
NAMES = ("episode", "step", "s", "a", "r", "s_next", "terminated")  # its columns
# and one more where these do not tell how the episodes ended, see `_columns`
ALL_NAMES = (*NAMES, "truncated")
HEADER = ",".join(NAMES)
_NUMBER = r"[-+]?(?:nan|inf|\d+(?:\.\d*)?(?:[eE][-+]?\d+)?)"  # one way to match any text, so no search
ROW = re.compile(
    rf"{_NUMBER}(?:,{_NUMBER}){{{len(NAMES) - 1},{len(ALL_NAMES) - 1}}}", re.ASCII
)  # such as 0,12,5,1,-0.02,4,0
CHANGED = f"a spreadsheet may have saved it with its own separators, commas, quotes or columns; {REMEDY}"

PACKAGE_NAME = "datapackage.json"
TEMPLATE = Path(__file__).with_name("datapackage_template.json")
# Fields of the section "rlrobot" that a recording cannot do without, and what JSON makes of them.
SECTION: dict[str, type | UnionType] = {
    "task": str, "robot": str, "scene": str | dict, "step_time": float | int | None,
    "episode_steps": int | None, "inputs": list, "outputs": list, "rewards": list,
    "method": str, "seed": int | None, "version": str, "platform": str, "rows": int,
}  # fmt: skip

Json = dict[str, Any]
Parts = tuple[Transitions, Source, Task | None]  # of a recording


def count_episodes(
    transitions: Transitions,
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Number of each row's episode, and of the step in it, arrays (n,); both count from 0."""
    ended = (transitions.terminated | transitions.truncated)[:-1]
    episode = np.cumsum(np.append(False, ended), dtype=np.int64)
    first_row = np.append(0, np.flatnonzero(ended) + 1)
    return episode, np.arange(len(episode), dtype=np.int64) - first_row[episode]


def _cut_off(episode: NDArray[Any], terminated: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Whether an episode was cut off in each row, array (n,), as far as the other columns tell.

    One that did not terminate before the next began was cut off. The last one counts as going on.
    """
    return np.append(np.diff(episode) != 0, False) & ~terminated


# --- writing ---


def to_files(source: Source, transitions: Transitions) -> tuple[bytes, str]:
    """What the two files hold: the rows, and the data package that describes them."""
    columns = _columns(transitions)
    csv = _to_csv(columns).encode()
    package = json.loads(TEMPLATE.read_text(encoding="utf-8"))
    package["name"] = re.sub(r"[^a-z0-9._-]", "-", source.task_name.lower())
    title = f"Transitions of {source.task_name}, recorded with {source.method}"
    package["title"] = title
    resource = package["resources"][0]
    resource["bytes"] = len(csv)
    resource["hash"] = f"sha256:{sha256(csv)}"
    schema = resource["schema"]
    schema["fields"] = [field for field in schema["fields"] if field["name"] in columns]
    limits = {field["name"]: field["constraints"] for field in schema["fields"]}
    limits["s"]["maximum"] = source.states.n - 1
    limits["s_next"]["maximum"] = source.states.n - 1
    limits["a"]["maximum"] = source.actions.n - 1
    limits["r"]["enum"] = sorted(set(source.rewards))
    known = {**vars(source), "task": source.task_name, "rows": len(transitions.s)}
    known["inputs"] = [_described(variable) for variable in source.states.inputs]
    known["outputs"] = [_described(variable) for variable in source.actions.outputs]
    section = {name: known[name] for name in SECTION}
    section["initial_state"] = int(transitions.s[0])
    if source.time_limit:
        section["time_limit"] = source.time_limit
    package["rlrobot"] = section
    text = json.dumps(
        package, indent=2, ensure_ascii=False, allow_nan=False, default=asdict
    )
    return csv, f"{text}\n"


def _columns(transitions: Transitions) -> dict[str, list[Any]]:
    """The columns of the file by name.

    There is a column ``truncated`` only where the others do not tell all of it: the last row was cut off, or an
    episode ended for good in the very step in which it was cut off.
    """
    episode, step = count_episodes(transitions)
    columns = {"episode": episode, "step": step, **transitions._asdict()}
    told = _cut_off(episode, transitions.terminated)
    names = NAMES if np.array_equal(told, transitions.truncated) else ALL_NAMES
    return {name: columns[name].tolist() for name in names}


def _to_csv(columns: dict[str, list[Any]]) -> str:
    """The rows as CSV text, the same for the same numbers. A reward reads back exactly."""
    lines = [",".join(columns)]
    for e, t, s, a, r, n, *ends in zip(*columns.values(), strict=True):
        flags = ",".join(f"{end:d}" for end in ends)
        lines.append(f"{e},{t},{s},{a},{r!r},{n},{flags}")
    return "\n".join(lines) + "\n"


def _described(variable: InputVariable | OutputVariable) -> Json:
    """What was given of a variable. JSON knows no infinity: an open end of the range is null."""
    fields = asdict(variable)
    order = ("name", "cuts", "sectors", "values", "unit", "words", "low", "high")
    given = {key: fields[key] for key in order if fields.get(key) is not None}
    return {
        key: None if value in (-math.inf, math.inf) else value
        for key, value in given.items()
    }


# --- reading ---


def read_folder(folder: Path, task: Task | None) -> Parts:
    """The parts of the recording there, which must be of `task` if one is given.

    Raises ValueError in one sentence for a file that is not whole and right, FileNotFoundError without one.
    """
    package = folder / PACKAGE_NAME
    csv = folder / CSV_NAME
    text = _text(csv)
    source, rows_due, digits_due = _read_package(_text(package), str(package))
    # First of all, for a bad row says more than a wrong checksum.
    transitions = _from_csv(text, source, str(csv))
    rows = len(transitions.s)
    if rows != rows_due:
        raise ValueError(
            f"{csv}: it has {rows} rows, {PACKAGE_NAME} says {rows_due}; {REMEDY}"
        )
    digits = sha256(text.encode())
    if digits != digits_due:
        raise ValueError(
            f"{csv}: its sha256 is {digits}, {PACKAGE_NAME} says {digits_due:.80}; {CHANGED}"
        )
    return transitions, source, _recorded_task(source, task, package)


def _text(path: Path) -> str:
    """Text of a file, each line ending in a line feed, so that its fingerprint is the same on any computer.

    Bytes that are no text become characters that no column can hold, so that their row is named.
    """
    if not path.is_file():
        together = f"a recording is {CSV_NAME} and {PACKAGE_NAME} together"
        alone = "a CSV file alone is read by its own path with task="
        raise FileNotFoundError(f"{path} is missing; {together}, {alone}")
    return path.read_text(encoding="utf-8-sig", errors="replace")


def _from_csv(text: str, source: Source, name: str) -> Transitions:
    """The rows in CSV `text`; `name` of the file is for messages, where rows count from 0 and lines from 1.

    Without a column ``truncated`` it is what the others tell. Raises ValueError that names the first bad row.
    """

    def where(row: int) -> str:
        return f"{name}, row {row} (line {row + 2})"

    header, *lines = text.split("\n")
    names = tuple(header.strip().split(","))
    if names not in (NAMES, ALL_NAMES):
        raise ValueError(
            f"{name}, line 1: the columns are {header[:100]!r}, expected {HEADER!r}; {CHANGED}"
        )
    if not lines or lines.pop() != "":
        raise ValueError(
            f"{where(len(lines))}: the file is cut off in the middle of this row; {REMEDY}"
        )
    if not lines:
        raise ValueError(f"{name}: there are no rows after the header; {REMEDY}")
    for row, line in enumerate(lines):
        if not ROW.fullmatch(line) or line.count(",") != len(names) - 1:
            raise ValueError(
                f"{where(row)}: expected {len(names)} numbers, found {line[:100]!r}; {CHANGED}"
            )
    columns = dict(zip(names, np.loadtxt(lines, delimiter=",", ndmin=2).T, strict=True))
    source.check_rows(columns, where)

    episode = columns.pop("episode")
    step = columns.pop("step")
    terminated = columns.pop("terminated").astype(bool)
    truncated = _cut_off(episode, terminated)
    if "truncated" in columns:
        truncated = columns.pop("truncated").astype(bool)
    transitions = Transitions(**columns, terminated=terminated, truncated=truncated)
    episode_due, step_due = count_episodes(transitions)
    bad = (episode != episode_due) | (step != step_due)
    if bad.any():
        row = int(np.argmax(bad))
        it = f"episode {episode[row]:.0f}, step {step[row]:.0f}"
        due = f"episode {episode_due[row]}, step {step_due[row]}"
        raise ValueError(
            f"{where(row)}: {it} stands where {due} is due: rows are missing or moved; {REMEDY}"
        )
    return transitions


def _read_package(text: str, name: str) -> tuple[Source, int, str]:
    """What the data package `text` says: the source, and the number of rows and fingerprint of the CSV file.

    name: of the file, for messages. Raises ValueError if the package cannot be used.
    """
    try:
        package = json.loads(text)
        resource = (_get(package, "resources", list, "") or [{}])[0]
        digits = _get(resource, "hash", str, "resources.0.").removeprefix("sha256:")
        section = _get(package, "rlrobot", dict, "")
        fields = {
            key: _get(section, key, kind, "rlrobot.") for key, kind in SECTION.items()
        }
        rows = fields.pop("rows")
        return _source(fields, section.get("time_limit")), rows, digits
    except (json.JSONDecodeError, RecursionError) as error:
        raise ValueError(f"{name}: this is not JSON ({error}); {REMEDY}") from error
    except (ValueError, TypeError, OverflowError) as error:
        raise ValueError(f"{name}: {error}; {REMEDY}") from error


def _get(fields: Json, key: str, kind: type | UnionType, prefix: str) -> Any:
    if not isinstance(fields, dict) or key not in fields:
        raise ValueError(f"the field {prefix}{key} is missing")
    if not isinstance(fields[key], kind):
        kind_name = getattr(kind, "__name__", str(kind))
        raise ValueError(
            f"the field {prefix}{key} must be of type {kind_name}, found {fields[key]!r:.80}"
        )
    return fields[key]


def _source(fields: Json, time_limit: int | None) -> Source:
    """The source that the fields of the section describe. Raises ValueError or TypeError if they describe none."""
    if isinstance(fields["scene"], dict):
        fields["scene"] = _room(fields["scene"])
    inputs = [_variable(InputVariable, given) for given in fields.pop("inputs")]
    states = StateSpace(inputs)
    outputs = [_variable(OutputVariable, given) for given in fields.pop("outputs")]
    actions = ActionSpace(outputs)
    rewards = check_numbers("rlrobot.rewards", fields.pop("rewards"))
    name = fields.pop("task")
    return Source(name, states, actions, rewards, time_limit=time_limit, **fields)


def _room(fields: Json) -> Room:
    """The room that a data package describes. Raises TypeError or ValueError if it describes none."""
    places = {name: place and tuple(place) for name, place in fields.items()}
    places["walls"] = tuple(tuple(wall) for wall in fields.get("walls", ()))
    return Room(**places)


def _variable(kind: type[Any], fields: Json) -> Any:
    """An input or output variable; an end of its range that is null stays open."""
    _get(fields, "name", str, f"{kind.__name__}.")
    return kind(**{key: value for key, value in fields.items() if value is not None})


def _recorded_task(source: Source, task: Task | None, package: Path) -> Task | None:
    """The recorded task: the given one, which must agree, or the toolkit's of this name if it agrees."""
    known = task
    if known is None and source.task_name in available_tasks():
        known = load_task(source.task_name)
    if known is None:
        return None
    difference = source.difference(known)
    if not difference:
        return known
    if task is not None:
        raise ValueError(
            f"{package}: not a recording of task {known.name}: {difference}; record it anew"
        )
    changed = (
        f"task {known.name} has changed since: {difference}; recording.task is None"
    )
    warnings.warn(f"{package}: {changed}", stacklevel=4)
    return None
