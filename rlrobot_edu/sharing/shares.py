"""A share of an experiment in one file, and all of them put together again."""

import tempfile
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from rlrobot_edu.experiments.compare import compare
from rlrobot_edu.experiments.comparison import Comparison
from rlrobot_edu.experiments.runs import Runs
from rlrobot_edu.experiments.store import ABOUT, Store
from rlrobot_edu.files import load_arrays, save_arrays, write_whole
from rlrobot_edu.learning.history import History
from rlrobot_edu.sharing.plan import Plan, parsed, read_plan
from rlrobot_edu.task.messages import check_count
from rlrobot_edu.task.task_file import load_task

Key = tuple[str, int]  # a method's label and the number of its repetition


class _Share(NamedTuple):
    """What the file of a share holds: the plan's text, (k, of) as in `compare`, and the files of a store by name."""

    plan: str
    share: tuple[int, int]
    files: dict[str, np.ndarray]


def shard(plan: str | Path, number: int, of: int, *, n_jobs: int = -1, progress: bool = True) -> Path:
    """Run one computer's share of an experiment, and put it into one file to hand in.

    Parameters
    ----------
    plan : str or Path
        The file that `plan` has written.
    number, of : int
        Which share, 1 to `of`, and how many there are.
    n_jobs : int
        Cores to use, -1 for all.
    progress : bool
        Show a progress bar.

    Returns
    -------
    Path
        The file, such as ``plan_7_of_30.npz``, beside the plan. A folder of the same name is a store, from which the
        same call goes on if it was stopped.

    Raises
    ------
    ValueError
        For a plan that was changed or is of another version, and for a share that does not exist.
    """
    path = Path(plan)
    text = path.read_text(encoding="utf-8")
    what = read_plan(text, path)
    check_count("of", of)
    check_count("number", number)
    if number > min(of, len(_keys(what))):
        raise ValueError(f"{path}: there is no share {number} of {of}; it has {len(_keys(what))} repetitions in all")
    share, folder = (number - 1, of), path.with_name(f"{path.stem}_{number}_of_{of}")
    _run(what, share, store=folder, n_jobs=n_jobs, progress=progress)
    files = {name: np.frombuffer((folder / name).read_bytes(), np.uint8) for name in _names(what, share)}
    save_arrays(whole := path.with_name(f"{folder.name}.npz"), "share", {"plan": text, "share": share}, files)
    return whole


def merge(
    shards: Sequence[str | Path],
    plan: str | Path | None = None,
    *,
    again: int = 1,
    rng: np.random.Generator | None = None,
) -> Comparison:
    """The one comparison that all shares of an experiment make, the same as `compare` makes in one go.

    Parameters
    ----------
    shards : sequence of str or Path
        The files that `shard` has written, in any order; different divisions may be mixed.
    plan : str or Path, optional
        The plan that all must follow; None is the one that most of them follow.
    again : int
        How many repetitions of each share are run again here, to compare; 0 trusts everybody.
    rng : numpy.random.Generator, optional
        Draws which; None draws what nobody can foresee.

    Returns
    -------
    Comparison
        With all tests and tables.

    Raises
    ------
    ValueError
        Names, a line each, the files that are damaged, of another plan, or hold what another one holds, too; those of
        which a repetition gave something else here; and the shares that are missing.

    Notes
    -----
    Two kinds of processors may differ in the last bit, and some steps later in a choice. So a repetition that gave
    something else is no proof of a forgery: let it be run again on a third computer.
    """
    faults, shares, rng = list[str](), dict[Path, _Share](), np.random.default_rng(rng)
    for path in map(Path, shards):
        try:
            shares[path] = load_arrays(path, "share", _unpack)
        except (ValueError, OSError) as error:
            faults.append(str(error))
    if plan is not None:
        text = Path(plan).read_text(encoding="utf-8")
    elif shares:
        text = Counter(one.plan for one in shares.values()).most_common(1)[0][0]
    else:
        raise ValueError("\n".join(faults) or "there is no share to merge")
    what = read_plan(text, plan or "the plan in the shares")
    found: dict[Key, tuple[Path, History]] = {}
    for path, one in shares.items():
        try:
            if one.plan != text:
                raise ValueError(f"it is of another plan: {_difference(one.plan, what)}")
            mine = _histories(one, what)
            if twice := [key for key in mine if key in found]:
                raise ValueError(f"{found[twice[0]][0]} also holds repetition {twice[0][1]} of {twice[0][0]}")
            found |= {key: (path, history) for key, history in mine.items()}
            for i in rng.permutation(len(mine))[:again]:
                _check_again(list(mine)[i], mine, what)
        except ValueError as error:
            faults.append(f"{path}: {error}")
    if missing := [n for n, key in enumerate(_keys(what)) if key not in found]:
        of = max(one.share[1] for one in shares.values())
        faults.append(f"missing are the shares {', '.join(map(str, sorted({n % of + 1 for n in missing})))} of {of}")
    if faults:
        raise ValueError("\n".join(faults))
    groups: dict[str, Runs] = {}
    for key in _keys(what):
        groups.setdefault(key[0], Runs()).append(found[key][1])
    return Comparison(load_task(what["task"]), groups, what["seed"])


def _keys(what: Plan) -> list[Key]:
    """All repetitions in the order in which `compare` shares them out."""
    return [(label, i) for label in what["methods"] for i in range(what["repetitions"])]


def _names(what: Plan, share: tuple[int, int]) -> dict[str, Key | None]:
    """The files of a share's store: its description, and a history for each of its repetitions."""
    mine = _keys(what)[share[0] :: share[1]]
    store = Store(".", {})
    return {ABOUT: None} | {store.path(*key).as_posix(): key for key in mine}


def _run(what: Plan, share: tuple[int, int], **how: Any) -> Comparison:
    same = {name: what[name] for name in ("methods", "repetitions", "steps", "seed")}
    return compare(what["task"], **same, **what["settings"], share=share, **how)


def _unpack(about: dict[str, Any], arrays: dict[str, np.ndarray]) -> _Share:
    first, of = map(int, about["share"])
    if not 0 <= first < of:
        raise ValueError(f"there is no share {first + 1} of {of}")
    return _Share(str(about["plan"]), (first, of), arrays)


def _difference(text: str, what: Plan) -> str:
    """What another plan says otherwise, in words."""
    other = parsed(text, "its plan")
    differ = [name for name in what if other.get(name) != what[name] and name != "digest"]
    return "; ".join(f"its {name} is {other.get(name)!s:.200}, not {what[name]!s:.200}" for name in differ)


def _histories(one: _Share, what: Plan) -> dict[Key, History]:
    """The repetitions of a share. Raises ValueError if one is missing, damaged or not of this experiment."""
    names = _names(what, one.share)
    if one.files.keys() != names.keys():
        raise ValueError(f"it does not hold {', '.join(map(str, names.keys() ^ one.files.keys()))}")
    with tempfile.TemporaryDirectory() as folder:
        for name, data in one.files.items():
            write_whole(Path(folder) / name, data.astype(np.uint8).tobytes())
        runs = _run(what, one.share, store=folder, n_jobs=1, progress=False)  # all is there: nothing is run
    histories = iter([history for label in what["methods"] for history in runs[label]])
    return {key: next(histories) for key in names.values() if key}


def _check_again(key: Key, mine: dict[Key, History], what: Plan) -> None:
    """Run one repetition again. Raises ValueError if it gives something else here."""
    everything = _keys(what)
    (here,) = _run(what, (everything.index(key), len(everything)), n_jobs=1, progress=False)[key[0]]
    for name in ("rewards", "q", "visits"):
        if not np.allclose(getattr(here, name), getattr(mine[key], name), rtol=1e-9, atol=1e-12):
            raise ValueError(
                f"repetition {key[1]} of {key[0]} gave other {name} here: forged, or another kind of processor; run it "
                "again on a third computer"
            )
