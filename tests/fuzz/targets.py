"""A target draws cases and attacks with one; all of them by name."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from hypothesis.strategies import SearchStrategy

from fuzz.contract import Fault

Case = dict[str, bytes]  # the files that make it, by name


@dataclass(frozen=True)
class Target:
    """A part of the public face under attack.

    cases: draws one; share: how many of all inputs it gets, beside the others'
    attack: tries the case whose files are in a folder, the present one; returns how it was answered, or raises Fault
    """

    name: str
    cases: SearchStrategy[Case]
    share: int
    attack: Callable[[Case], str]

    def __call__(self, case: Case) -> str:
        """Try a case in the present folder, where nothing else is, and see that it changes no other file there."""
        _empty(Path())
        return self.attack(case)


def lay(files: Case) -> None:
    """Put these files into the present folder."""
    for name, data in files.items():
        Path(name).parent.mkdir(parents=True, exist_ok=True)
        Path(name).write_bytes(data)


def snapshot(folder: Path = Path()) -> dict[str, tuple[int, int]]:
    """What is in a folder and below: size and time of each file."""
    found = {}
    for root, _, names in os.walk(folder):
        for name in names:
            known = os.lstat(os.path.join(root, name))
            found[os.path.join(root, name)] = (known.st_size, known.st_mtime_ns)
    return found


def unchanged(
    before: dict[str, tuple[int, int]],
    own: tuple[str, ...] = (),
    new: tuple[str, ...] = (),
) -> None:
    """Raises Fault if a file went, came or was changed since `before`.

    own, new: how the names begin that may do so, that may come
    """
    now = snapshot()
    changed = [name for name, known in before.items() if now.get(name) != known]
    changed += [
        name
        for name in now
        if name not in before and not (new and name.startswith(new))
    ]
    changed = [name for name in changed if not name.startswith(own)] if own else changed
    if changed:
        raise Fault(
            f"changed {', '.join(changed)[:200]}",
            "a file that is none of the call's was changed",
        )


def _empty(folder: Path) -> None:
    for path in folder.iterdir():
        if path.is_dir() and not path.is_symlink():
            _empty(path)
            path.rmdir()
        else:
            path.unlink()
