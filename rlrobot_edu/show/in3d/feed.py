"""What a page is told of scenes, as numbers and names that JSON knows: `room.js` and `player.js` draw them."""

from typing import Any

import numpy as np

from rlrobot_edu.robots.scene import Scene, Solid
from rlrobot_edu.show.palette import ROLE

Told = dict[str, Any]


def _short(numbers: np.ndarray) -> list[Any]:
    """Numbers [m] to a hundredth of a millimetre: more digits nobody sees, and a page is to be small."""
    short: list[Any] = (np.round(numbers, 5) + 0.0).tolist()  # + 0.0: no −0
    return short


def _place(solid: Solid) -> list[Any]:
    """The upper three rows of a pose, row by row; 12 numbers."""
    return _short(solid.pose[:3].ravel())


def room(scene: Scene) -> Told:
    """All that is in the scene and how it looks; only what is a wall, and stays, has its place here."""
    solids = []
    for solid in scene.solids:
        place = _place(solid) if solid.role == "wall" else None
        solids.append(solid._asdict() | {"size": _short(np.array(solid.size)), "pose": place})
    return {"bounds": scene.bounds, "colours": ROLE, "solids": solids}


def frame(scene: Scene, reward: float | None = None) -> Told:
    """Where everything that may move is, and the laser beams; reward: of the step that led here."""
    places = {solid.name: _place(solid) for solid in scene.solids if solid.role != "wall"}
    return {"places": places, "beams": _short(scene.beams), "reward": None if reward is None else float(reward)}
