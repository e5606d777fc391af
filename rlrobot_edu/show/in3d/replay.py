"""Where everything is in each scene of a film, packed for a page; replay.js, its other half, makes a replay of it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.describe import NEAR, jumps, loss_of
from rlrobot_edu.show.in3d import looks
from rlrobot_edu.show.in3d.story import story
from rlrobot_edu.show.room.scene_data import scene_data

NO_REPLAY = {"type": "replay", "path": "", "names": []}  # the page is live again


def places(scene: Scene) -> dict[str, np.ndarray]:
    """Where everything is that may move, and each beam; by name an array (4, 4)."""
    found = {solid.name: solid.pose for solid in scene.solids if solid.role != "wall"}
    for i, (start, end) in enumerate(scene.beams):
        if math.dist(start, end) >= NEAR:
            end = start  # too small to be seen
        found[f"beams/{i}"] = looks.beam(start, end)
    return found


def telling(rewards: Sequence[float]) -> int:
    """The scene at which a film opens that does not move: the last that earned most, so that nearly all of it was done.

    Counted from 0; −1 where nothing was earned: it opens at its end.
    """
    most = max(rewards, default=0.0)
    if most <= 0:
        return -1
    return max(i for i, r in enumerate(rewards) if r == most)


def replay(
    scenes: Sequence[Scene],
    rewards: Sequence[float],
    seconds_per_frame: float,
    notes: Sequence[str],
    opens: str,
    task: str,
    rules: str = "",
) -> dict[str, Any]:
    """The command that gives a page its replay.

    rewards, notes: one for each scene, or none; opens: ``playing``, or ``at its end``
    task: what the robot is to do, or empty; rules: what earns which reward, or empty

    The places are 32-bit numbers in the order (thing, number, scene), which packs well; a thing has 12 of them, the
    first three rows of its transform. What a scene does not hold is NaN there.
    """
    placed = [places(scene) for scene in scenes]
    names = list(dict.fromkeys(name for each in placed for name in each))
    moves = np.full((len(names), 12, len(scenes)), np.nan, dtype="<f4")
    for i, each in enumerate(placed):
        for k, name in enumerate(names):
            if name in each:
                moves[k, :, i] = each[name][:3].ravel()
    told = story(scenes, rewards, task, rules) if len(rewards) else None
    put = [i for i, (a, b) in enumerate(pairwise(scenes), start=1) if jumps(a, b)]
    return {
        "type": "replay",
        "path": "",
        "names": names,
        "moves": moves.tobytes(),
        "rate": 1 / seconds_per_frame,
        "map": {**scene_data(scenes[-1]), "loss": loss_of(rewards), "put": put},
        "put": put,  # numbers of the scenes in which it stands where it was put
        "notes": list(notes),
        "headline": told.headline if told else "",
        "moments": told.moments if told else [],
        "key": told.key if told else [],
        "aim": told.aim if told else "",
        "opens": opens,
        "telling": telling(rewards),
    }
