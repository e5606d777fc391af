"""The valid files that are damaged, one of each kind: of a small robot that needs no physics, so all of it is quick."""

from __future__ import annotations

import tempfile
from functools import cache
from pathlib import Path

import numpy as np

import rlrobot_edu as rl
from rlrobot_edu.learning.history import History

TASK = "worked_example"
STEPS = 60
STORE = dict(
    methods=["Q+SR", "TOSL+QBIASSR"], repetitions=2, steps=30, n_jobs=1, progress=False
)


@cache
def recording() -> rl.Recording:
    """Two episodes."""
    return rl.record(rl.Agent(TASK, seed=0), rl.make_env(TASK, 0), STEPS)


@cache
def model() -> rl.SampleModel:
    """What is remembered of them."""
    return rl.SampleModel.from_recording(recording(), unseen="siblings")


@cache
def agent() -> rl.Agent:
    """It has learned a little, plans, and is in the middle of an episode."""
    agent = rl.Agent(TASK, planner="dyna", planning_steps=1, seed=0)
    rl.learn(agent, rl.make_env(model(), 0), 45, progress=False)
    return agent


@cache
def history() -> History:
    """One learning process."""
    return rl.learn(
        rl.Agent(TASK, seed=0), rl.make_env(model(), 0), 100, keep=True, progress=False
    )


@cache
def files() -> dict[str, dict[str, bytes]]:
    """The bytes of each kind's files, by kind and name."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        recording().save(folder / "recording")
        for kind, thing in (
            ("model", model()),
            ("agent", agent()),
            ("history", history()),
        ):
            thing.save(folder / kind / f"{kind}.npz")
        rl.compare(model(), store=folder / "store", **STORE)
        rows = [recording().s, recording().a, recording().s_next, recording().r]
        (folder / "sheet").mkdir()
        written = (folder / "recording" / "transitions.csv").read_bytes()
        (folder / "sheet" / "mine.csv").write_bytes(written)
        (folder / "legacy").mkdir()
        np.save(folder / "legacy" / "legacy.npy", np.column_stack(rows))
        return {
            kind.name: {
                path.relative_to(kind).as_posix(): path.read_bytes()
                for path in sorted(kind.rglob("*.*"))
            }
            for kind in sorted(folder.iterdir())
        }
