"""How much tuning does the method need? Runs tuning_registered.json; writes docs/studies/how_much_tuning.md.

``make atlas`` does all of it, from nothing. Every finished part is kept in results/how_much_tuning; the same call goes
on from there. ``page`` writes page and pictures anew from how_much_tuning.npz, and runs nothing.
"""

from __future__ import annotations

import argparse
import hashlib
import io
import json
import time
from collections.abc import Iterator, MutableMapping
from pathlib import Path

import numpy as np
from how_much_tuning_worlds import MAZES, REGISTERED, Plan, scores

from rlrobot_edu.files import write_whole

HERE = Path(__file__).parent
DATA, STORE = HERE / "how_much_tuning.npz", HERE.parent / "results" / "how_much_tuning"
METHODS = [
    "Q+SR",
    "TOSL+SR",
    "Q+QBIASSR",
    "TOSL+QBIASSR",
]  # neither, traces, bias, both
OURS = "TOSL+QBIASSR"  # the paper's method
Scores = MutableMapping[str, np.ndarray]
UNIT = 1000  # of the file: rewards are kept in thousandths


class Study:
    """All scores of the study by part, such as ``judged/wander_1k/TOSL+SR/17``; a part that is missing is run.

    plan: what is registered; parts: where the scores are; n_jobs: cores, or None to run nothing
    """

    def __init__(self, plan: Plan, parts: Scores, n_jobs: int | None = None) -> None:
        self.plan = plan
        self.parts = parts
        self.n_jobs = n_jobs
        self._common: dict[tuple[str, str | None], str] = {}
        self._ends: dict[str, tuple[float, float]] = {}

    def part(
        self, stage: str, world: str, method: str, settings: list[str], robots: int
    ) -> np.ndarray:
        """Final average rewards, array (settings, robots)."""
        which = settings[0] if len(settings) == 1 else "all"
        name = f"{stage}/{world}/{method}/{which}"
        if name not in self.parts:
            if self.n_jobs is None:
                raise ValueError(f"the data lack {name}; `make atlas` runs it")
            began = time.perf_counter()
            found = scores(
                self.plan, world, method, settings, robots, stage, self.n_jobs
            )
            self.parts[name] = np.round(UNIT * found).astype(np.int16)
            print(f"{name}: {time.perf_counter() - began:.0f} s", flush=True)
        return self.parts[name] / UNIT

    def swept(self, world: str, method: str) -> np.ndarray:
        """The sweep of a method, array (settings, robots)."""
        sizes = self.plan["sizes"]
        n, robots = sizes["settings"], sizes["robots"]
        if world == "friction":
            n, robots = sizes["friction settings"], sizes["friction robots"]
        return self.part("sweep", world, method, [str(i) for i in range(n)], robots)

    def judged(self, world: str, method: str, setting: str) -> np.ndarray:
        """The judging robots at a setting, array (robots,)."""
        robots = self.plan["sizes"]["judging robots"][world]
        return self.part("judged", world, method, [setting], robots)[0]

    def held_out(self, world: str, setting: str) -> np.ndarray:
        """The robots of a hold-out with the paper's method, array (robots,)."""
        kind = "maze" if world in MAZES else world
        robots = self.plan["sizes"]["hold-out robots"][kind]
        return self.part("hold-out", world, OURS, [setting], robots)[0]

    @property
    def worlds(self) -> list[str]:
        """Where methods are tuned: the six tasks and new ground."""
        return [*self.plan["tasks"], "new ground"]

    def winner(self, world: str, method: str) -> str:
        """The number of the setting that is best for this world."""
        means = {world: self.swept(world, method).mean(axis=1)}
        return self._best(method, means)

    def common(self, method: str, without: str | None = None) -> str:
        """The number of the setting that is best for all six tasks, or for those others than `without`."""
        if (method, without) not in self._common:
            means = {
                task: self.scored(task, self.swept(task, method).mean(axis=1))
                for task in self.plan["tasks"]
                if task != without
            }
            self._common[method, without] = self._best(method, means)
        return self._common[method, without]

    def _best(self, method: str, means: dict[str, np.ndarray]) -> str:
        """The best of the candidates, as new robots see it; means: of each setting, by world."""
        sizes = self.plan["sizes"]
        order = np.argsort(-np.mean([*means.values()], axis=0), kind="stable")
        found = {}
        for setting in map(str, order[: sizes["candidates"]]):
            anew = []
            for world in means:
                robots = sizes["choosing robots"]
                earned = self.part("choice", world, method, [setting], robots).mean()
                anew.append(
                    self.scored(world, earned) if len(means) > 1 else float(earned)
                )
            found[setting] = float(np.mean(anew))
        return max(found, key=lambda setting: found[setting])

    def ends(self, world: str) -> tuple[float, float]:
        """What random actions earn, and the best winner of all methods."""
        if world not in self._ends:
            random = self.judged(world, "Q+SR", "random").mean()
            best = [
                self.judged(world, method, self.winner(world, method)).mean()
                for method in METHODS
            ]
            self._ends[world] = float(random), float(max(best))
        return self._ends[world]

    def scored(self, world: str, earned: np.ndarray | float) -> np.ndarray | float:
        """Rewards on the scale from 0, random actions, to 1, the best winner."""
        low, high = self.ends(world)
        return (earned - low) / (high - low)

    def kinds(self, world: str, method: str) -> dict[str, str]:
        """The settings that are judged, by what they are; in new ground only two."""
        found = {"paper's": "paper", "winner": self.winner(world, method)}
        if world in self.plan["tasks"]:
            found["others'"] = self.common(method, without=world)
            found["common"] = self.common(method)
        return found

    def run(self) -> None:
        """Run whatever is missing."""
        plan = self.plan
        for world in self.worlds:
            for method in METHODS:
                self.swept(world, method)
        for method in METHODS:
            self.swept("friction", method)
        for world in self.worlds:
            self.ends(world)
            for method in METHODS:
                for setting in self.kinds(world, method).values():
                    self.judged(world, method, setting)
        for world in [*MAZES, *list(plan["sizes"]["hold-out robots"])[1:]]:
            for setting in ("paper", self.common(OURS)):
                self.held_out(world, setting)


class Folder(MutableMapping[str, np.ndarray]):
    """Arrays in files below a folder, by name; each is written whole."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def _path(self, name: str) -> Path:
        return self.folder / f"{name}.npy"

    def __getitem__(self, name: str) -> np.ndarray:
        if not self._path(name).is_file():
            raise KeyError(name)
        return np.load(self._path(name), allow_pickle=False)

    def __setitem__(self, name: str, scores: np.ndarray) -> None:
        buffer = io.BytesIO()
        np.save(buffer, scores, allow_pickle=False)
        self._path(name).parent.mkdir(parents=True, exist_ok=True)
        write_whole(self._path(name), buffer.getvalue())

    def __delitem__(self, name: str) -> None:
        self._path(name).unlink()

    def __iter__(self) -> Iterator[str]:
        for path in sorted(self.folder.glob("*/*/*/*.npy")):
            yield path.relative_to(self.folder).with_suffix("").as_posix()

    def __len__(self) -> int:
        return len([*iter(self)])


def folder_of(plan: Plan, store: Path) -> Path:
    """The folder of this plan: another plan has another one, so results never mix."""
    text = json.dumps(plan, sort_keys=True)
    return store / hashlib.sha256(text.encode()).hexdigest()[:12]


def run(plan: Plan, store: Path, data: Path, n_jobs: int) -> None:
    """Run all that is missing, and write all scores into one file."""
    parts = Folder(folder_of(plan, store))
    Study(plan, parts, n_jobs).run()
    buffer = io.BytesIO()
    np.savez_compressed(buffer, **dict(parts))
    write_whole(data, buffer.getvalue())


def read(plan: Plan, data: Path) -> Study:
    """The study as it was run; it runs nothing."""
    with np.load(data, allow_pickle=False) as file:
        return Study(plan, dict(file))


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("what", choices=("all", "run", "page"))
    parser.add_argument("--n-jobs", type=int, default=-1)
    given = parser.parse_args()
    if given.what in ("all", "run"):
        run(REGISTERED, STORE, DATA, given.n_jobs)
    if given.what in ("all", "page"):
        from how_much_tuning_page import write_page

        print(write_page(read(REGISTERED, DATA)))


if __name__ == "__main__":
    main()
