"""The two files of a recording, transitions.csv and datapackage.json: written, and refused if not whole.

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

from rlrobot_edu.checks import check_numbers
from rlrobot_edu.files import sha256
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.columns import CHANGED, REMEDY, from_csv, to_csv
from rlrobot_edu.models.source import Source
from rlrobot_edu.task.room import Room
from rlrobot_edu.task.spaces import ActionSpace, StateSpace
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import available_tasks, load_task
from rlrobot_edu.task.variables import InputVariable, OutputVariable

CSV_NAME = "transitions.csv"
PACKAGE_NAME = "datapackage.json"
# Fields of the section "rlrobot" that a recording cannot do without, and what JSON makes of them.
SECTION: dict[str, type | UnionType] = {
    "task": str, "robot": str, "scene": str | dict, "step_time": float | int | None,
    "episode_steps": int | None, "inputs": list, "outputs": list, "rewards": list,
    "method": str, "seed": int | None, "version": str, "platform": str, "rows": int,
}  # fmt: skip

Json = dict[str, Any]
Parts = tuple[Transitions, Source, Task | None]  # of a recording


def to_files(source: Source, transitions: Transitions) -> tuple[bytes, str]:
    """What the two files hold: the rows, and the data package that describes them."""
    csv = to_csv(transitions).encode()
    package = json.loads(
        Path(__file__)
        .with_name("datapackage_template.json")
        .read_text(encoding="utf-8")
    )
    package["name"] = re.sub(r"[^a-z0-9._-]", "-", source.task_name.lower())
    package["title"] = (
        f"Transitions of {source.task_name}, recorded with {source.method}"
    )
    (resource,) = package["resources"]
    resource |= {"bytes": len(csv), "hash": f"sha256:{sha256(csv)}"}
    limits = {
        field["name"]: field["constraints"] for field in resource["schema"]["fields"]
    }
    limits["s"]["maximum"] = limits["s_next"]["maximum"] = source.states.n - 1
    limits["a"]["maximum"] = source.actions.n - 1
    limits["r"]["enum"] = sorted(set(source.rewards))
    known = {**vars(source), "task": source.task_name, "rows": len(transitions.s)}
    known["inputs"] = list(map(_described, source.states.inputs))
    known["outputs"] = list(map(_described, source.actions.outputs))
    section = {name: known[name] for name in SECTION} | {
        "initial_state": int(transitions.s[0])
    }
    package["rlrobot"] = section | (
        {"time_limit": source.time_limit} if source.time_limit else {}
    )
    return csv, json.dumps(
        package, indent=2, ensure_ascii=False, allow_nan=False, default=asdict
    ) + "\n"


def _room(fields: Json) -> Room:
    """The room that a data package describes. Raises TypeError or ValueError if it describes none."""
    places = {name: place and tuple(place) for name, place in fields.items()}
    return Room(**places | {"walls": tuple(map(tuple, fields.get("walls", ())))})


def _described(variable: InputVariable | OutputVariable) -> Json:
    """What was given of a variable. JSON knows no infinity: an open end of the range is null."""
    fields = asdict(variable)
    order = ("name", "cuts", "sectors", "values", "unit", "words", "low", "high")
    given = {key: fields[key] for key in order if fields.get(key) is not None}
    return {
        key: None if value in (-math.inf, math.inf) else value
        for key, value in given.items()
    }


def read_folder(folder: Path, task: Task | None) -> Parts:
    """The parts of the recording there, which must be of `task` if one is given.

    Raises ValueError in one sentence for a file that is not whole and right, FileNotFoundError without one.
    """
    package = folder / PACKAGE_NAME
    csv = folder / CSV_NAME
    text = _text(csv)
    source, rows_due, digits_due = read_package(_text(package), str(package))
    # First of all, for a bad row says more than a wrong checksum.
    transitions = from_csv(text, source, str(csv))
    if (rows := len(transitions.s)) != rows_due:
        raise ValueError(
            f"{csv}: it has {rows} rows, {PACKAGE_NAME} says {rows_due}; {REMEDY}"
        )
    if (digits := sha256(text.encode())) != digits_due:
        raise ValueError(
            f"{csv}: its sha256 is {digits}, {PACKAGE_NAME} says {digits_due:.80}; {CHANGED}"
        )
    return transitions, source, recorded_task(source, task, package)


def _text(path: Path) -> str:
    """Text of a file, each line ending in a line feed, so that its fingerprint is the same on any computer.

    Bytes that are no text become characters that no column can hold, so that their row is named.
    """
    if not path.is_file():
        raise FileNotFoundError(
            f"{path} is missing; a recording is {CSV_NAME} and {PACKAGE_NAME} together"
        )
    return path.read_text(encoding="utf-8-sig", errors="replace")


def read_package(text: str, name: str) -> tuple[Source, int, str]:
    """What the data package `text` says: the source, and the number of rows and fingerprint of the CSV file.

    name: of the file, for messages. Raises ValueError if the package cannot be used.
    """
    try:
        package = json.loads(text)
        resource = (_get(package, "resources", list, "") or [{}])[0]
        digits = _get(resource, "hash", str, "resources.0.").removeprefix("sha256:")
        section = _get(package, "rlrobot", dict, "")
        values = {
            key: _get(section, key, kind, "rlrobot.") for key, kind in SECTION.items()
        }
        values["time_limit"] = section.get("time_limit")
        if isinstance(scene := values["scene"], dict):
            values["scene"] = _room(scene)
        task_name, rows, rewards = (
            values.pop(key) for key in ("task", "rows", "rewards")
        )
        states = StateSpace(
            [_variable(InputVariable, fields) for fields in values.pop("inputs")]
        )
        actions = ActionSpace(
            [_variable(OutputVariable, fields) for fields in values.pop("outputs")]
        )
        source = Source(
            task_name,
            states,
            actions,
            check_numbers("rlrobot.rewards", rewards),
            **values,
        )
    except (json.JSONDecodeError, RecursionError) as error:
        raise ValueError(f"{name}: this is not JSON ({error}); {REMEDY}") from error
    except (ValueError, TypeError, OverflowError) as error:
        raise ValueError(f"{name}: {error}; {REMEDY}") from error
    return source, rows, digits


def _get(fields: Json, key: str, kind: type | UnionType, prefix: str) -> Any:
    if not isinstance(fields, dict) or key not in fields:
        raise ValueError(f"the field {prefix}{key} is missing")
    if not isinstance(fields[key], kind):
        kind_name = getattr(kind, "__name__", str(kind))
        raise ValueError(
            f"the field {prefix}{key} must be of type {kind_name}, found {fields[key]!r:.80}"
        )
    return fields[key]


def _variable(kind: type[Any], fields: Json) -> Any:
    """An input or output variable; an end of its range that is null stays open."""
    _get(fields, "name", str, f"{kind.__name__}.")
    return kind(**{key: value for key, value in fields.items() if value is not None})


def recorded_task(source: Source, task: Task | None, package: Path) -> Task | None:
    """The recorded task: the given one, which must agree, or the toolkit's of this name if it agrees."""
    known = task or (
        load_task(source.task_name) if source.task_name in available_tasks() else None
    )
    if known is None or not (difference := source.difference(known)):
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
