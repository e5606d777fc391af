"""The plan of an experiment: what is compared, written down before anybody runs it."""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from rlrobot_edu.files import sha256, write_whole
from rlrobot_edu.task.messages import check_count
from rlrobot_edu.task.task_file import load_task
from rlrobot_edu.version import __version__

Plan = dict[str, Any]


def plan(
    path: str | Path,
    task: str,
    methods: Sequence[str] | Mapping[str, Mapping[str, Any]],
    repetitions: int = 30,
    *,
    steps: int = 3600,
    seed: int = 0,
    **settings: Any,
) -> Path:
    """Write down an experiment, for `shard` to run in parts on many computers.

    Parameters
    ----------
    path : str or Path
        The file to write, such as ``plan.json``.
    task : str
        Name of a task, or the path of your own, which must then lie in the same place on each computer.
    methods : sequence of str, or mapping
        Names of methods, or parameters of `Agent` by a label, as in `compare`.
    repetitions, steps, seed : int
        As in `compare`.
    **settings
        Parameters of `Agent` for all methods.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    ValueError
        For what cannot be written as JSON, or is no task.
    """
    check_count("repetitions", repetitions)
    what: Plan = {"task": str(task), "methods": methods, "repetitions": repetitions, "steps": steps, "seed": seed}
    what |= {"settings": settings, "version": __version__, "task's content": _content(task)}
    try:
        text = json.dumps(what | {"digest": digest(what)}, indent=1, ensure_ascii=False)
    except TypeError as error:
        raise ValueError(
            f"{path}: a plan holds names and numbers alone ({error}); give methods by their names"
        ) from error
    write_whole(path, text + "\n")
    return Path(path)


def digest(what: Plan) -> str:
    """Fingerprint of all that a plan says, but for its digest."""
    said = {name: value for name, value in what.items() if name != "digest"}
    return sha256(json.dumps(said, sort_keys=True).encode())[:16]


def parsed(text: str, where: str | Path) -> Plan:
    """What a plan says. Raises ValueError if it was changed since it was written."""
    try:
        what: Plan = json.loads(text)
        is_whole = what["digest"] == digest(what)
    except (ValueError, KeyError, TypeError) as error:
        raise ValueError(f"{where}: this is no plan that rl.plan has written ({error!s:.200})") from error
    if not is_whole:
        raise ValueError(f"{where}: this plan was changed after it was written; get it anew, or write one with rl.plan")
    return what


def read_plan(text: str, where: str | Path) -> Plan:
    """The same for a plan that is to be run here; raises ValueError also if task or toolkit are others here."""
    what = parsed(text, where)
    for name, here in {"version": __version__, "task's content": _content(what["task"])}.items():
        if what[name] != here:
            raise ValueError(f"{where}: the {name} is {what[name]} in this plan and {here} on this computer")
    return what


def _content(task: str) -> str:
    return load_task(task).fingerprint[:16]
