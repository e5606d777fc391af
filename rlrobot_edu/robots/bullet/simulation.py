"""What the robots in PyBullet (three-dimensional physics) share: a world of their own, its clock and its looks."""

from __future__ import annotations

import os
import sys
import weakref
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from itertools import product
from pathlib import Path

import numpy as np

from rlrobot_edu.robots.scene import Solid, pose
from rlrobot_edu.task.robot_cards import ROBOTS


@contextmanager
def _quiet_stderr() -> Iterator[None]:
    """What C code writes to stderr (file descriptor 2) is lost inside; Python's own messages come through after."""
    sys.stderr.flush()
    kept, nothing = os.dup(2), os.open(os.devnull, os.O_WRONLY)
    os.dup2(nothing, 2)
    try:
        yield
    finally:
        os.dup2(kept, 2)
        os.close(nothing)
        os.close(kept)


try:
    with _quiet_stderr():
        import pybullet
except ImportError:
    raise ImportError(
        "this robot is simulated by PyBullet, which is not installed: with Python 3.11 to 3.13 on Linux x86-64, "
        "Windows or macOS run pip install 'rlrobot-edu[arm]'; everything else works without it"
    ) from None

GRAVITY = 9.81  # [m/s²]
# groups of what may meet; PyBullet puts its rays into group 1
_BEAM, _FIXED, _FLOOR, _ROBOT, _MIRROR = 1, 2, 64, 128, 256
# of a box, by the numbers of its corners; each side has two
_SIDES = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
_TRIANGLES = [i for a, b, c, d in _SIDES for i in (a, b, c, a, c, d)]


class BulletWorld:
    """A world without a window, for one robot alone; whatever PyBullet can do, it does in this world.

    physics_hz: physics steps a second [1/s]

    The world ends with `close`, or once nobody holds it any more.
    """

    def __init__(self, physics_hz: int) -> None:
        self._client = pybullet.connect(pybullet.DIRECT)
        self.close = weakref.finalize(self, pybullet.disconnect, self._client)
        self._hz = physics_hz
        self.setGravity(0, 0, -GRAVITY)
        self.setTimeStep(1 / physics_hz)
        self.setPhysicsEngineParameter(
            deterministicOverlappingPairs=1,  # runs repeat bit for bit
            solverResidualThreshold=0.0,  # servos that hold still do not sink
            collisionFilterMode=0,  # two bodies meet only if each has the other's group in its mask
        )

    def __getattr__(self, name: str):
        """PyBullet's function or constant of this name; the function acts on this world."""
        value = getattr(pybullet, name)
        if callable(value):
            value = partial(value, physicsClientId=self._client)
        self.__dict__[name] = value
        return value

    def run(self, seconds: float) -> None:
        """Let time pass."""
        for _ in range(max(1, round(seconds * self._hz))):
            self.stepSimulation()

    def load(
        self, urdf: str | Path, position: tuple[float, float, float], yaw: float = 0.0, fixed: bool = False
    ) -> int:
        """Put the robot that a URDF file describes at a place [m, rad]; returns the number of its body."""
        turned = self.getQuaternionFromEuler((0, 0, yaw))
        inertia = self.URDF_USE_INERTIA_FROM_FILE
        body = self.loadURDF(str(urdf), position, turned, useFixedBase=fixed, flags=inertia)
        for link in range(-1, self.getNumJoints(body)):
            self.setCollisionFilterGroupMask(body, link, _ROBOT, _FIXED | _FLOOR)
        return body

    def add(self, solid: Solid) -> int:
        """Put a solid that nothing can move into the world; returns the number of its body."""
        if solid.shape == "box":
            shape = self.createCollisionShape(self.GEOM_BOX, halfExtents=[v / 2 for v in solid.size])
        else:
            radius, height = solid.size
            shape = self.createCollisionShape(self.GEOM_CYLINDER, radius=radius, height=height)
        return self._fix(shape, solid.pose)

    def _fix(self, shape: int, place: np.ndarray) -> int:
        """A body of this shape that does not move, with its homogeneous transform, array (4, 4) [m]."""
        # "maximal coordinates": a plain rigid body; the other kind would be solved like a robot in every step
        where = place[:3, 3].tolist(), quaternion_of(place)
        body = self.createMultiBody(0, shape, -1, *where, useMaximalCoordinates=1)
        self.setCollisionFilterGroupMask(body, -1, _FIXED, _ROBOT)
        return body

    def add_floor(self) -> int:
        """Put a wide floor into the world, its top at z = 0; returns the number of its body."""
        floor = self.add(Solid("floor", "box", (40, 40, 1), pose(0, 0, -0.5), "wall"))
        self.setCollisionFilterGroupMask(floor, -1, _FLOOR, _ROBOT)
        return floor

    def floor_only(self, body: int, link: int) -> None:
        """Let this link of a robot meet the floor and nothing else."""
        self.setCollisionFilterGroupMask(body, link, _ROBOT, _FLOOR)

    def add_walls(self, walls: list[Solid]) -> None:
        """Put boxes into the world that stop robots and reflect laser beams.

        PyBullet finds where a ray meets a box to some millimetres only, but where it meets a triangle exactly. So the
        beams see the boxes' sides as triangles, in a group of their own, that nothing can bump into.
        """
        for wall in walls:
            self.add(wall)
        corners = np.array(list(product((-0.5, 0.5), repeat=3)))
        vertices = [wall.pose[:3, 3] + (corners * wall.size) @ wall.pose[:3, :3].T for wall in walls]
        triangles = [8 * i + corner for i in range(len(walls)) for corner in _TRIANGLES]
        if walls:
            mirror = self.createCollisionShape(
                self.GEOM_MESH,
                vertices=np.concatenate(vertices).tolist(),
                indices=triangles,
                flags=self.GEOM_FORCE_CONCAVE_TRIMESH,
            )
            self.setCollisionFilterGroupMask(self.createMultiBody(0, mirror), -1, _MIRROR, _BEAM)

    def lengths_of_beams(self, starts: np.ndarray, ends: np.ndarray) -> list[float]:
        """How far beams get from `starts` towards `ends`, arrays (n, 3) [m], as parts of the whole way, at most 1."""
        hits = self.rayTestBatch(starts.tolist(), ends.tolist(), collisionFilterMask=_MIRROR)
        return [hit[2] for hit in hits]

    def joints(self, body: int) -> dict[str, int]:
        """Number of each joint, and so of the link it carries, by the joint's name."""
        return {self.getJointInfo(body, i)[1].decode(): i for i in range(self.getNumJoints(body))}

    def link_pose(self, body: int, link: int) -> np.ndarray:
        """Homogeneous transform of a link's frame, −1 for the base; array (4, 4) [m]."""
        if link == -1:
            return transform(*self.getBasePositionAndOrientation(body))
        return transform(*self.getLinkState(body, link, computeForwardKinematics=True)[4:6])

    def solids(self, body: int, leader: str) -> tuple[Solid, ...]:
        """The visual shapes of a robot where they are now; dark ones are drawn as wheels.

        leader: name of the link whose first shape becomes ``robot/body``
        """
        names = {-1: self.getBodyInfo(body)[0].decode()} | {
            i: self.getJointInfo(body, i)[12].decode() for i in range(self.getNumJoints(body))
        }
        poses, solids, seen = {link: self.link_pose(body, link) for link in names}, [], Counter()
        for _, link, kind, size, _, position, turned, colour, *_ in self.getVisualShapeData(body):
            name = f"robot/{names[link]}" + (f"_{seen[link] + 1}" if seen[link] else "")
            if names[link] == leader and not seen[link]:
                name = "robot/body"
            seen[link] += 1
            shapes = {
                self.GEOM_BOX: ("box", size),
                self.GEOM_CYLINDER: ("cylinder", (size[1], size[0])),
                self.GEOM_SPHERE: ("sphere", size[:1]),
            }
            role = "wheel" if max(colour[:3]) < 0.3 else "robot"
            solids.append(Solid(name, *shapes[kind], poses[link] @ transform(position, turned), role))
        return tuple(solids)


class BulletRobot:
    """What the robots of this module do alike: rest, begin again, act and sense.

    A robot builds its world, and says how it carries out a command (`_drive`) and what it senses (`_sense`).

    name: of the robot's card
    step_time: duration of one control step [s]
    """

    def __init__(self, name: str, world: BulletWorld, step_time: float) -> None:
        self._card, self._world, self._step_time = ROBOTS[name], world, step_time
        self.close = world.close
        self._stand_still()
        world.run(1.0)  # until nothing moves any more
        self._beginning = world.saveState()
        self._readings = self._sense()

    def _drive(self, command: Mapping[str, float]) -> None:
        raise NotImplementedError

    def _sense(self) -> dict[str, float]:
        raise NotImplementedError

    def _stand_still(self) -> None:
        self._drive(dict.fromkeys(self._card.commands, 0.0))

    def reset(self, rng: np.random.Generator | None = None) -> dict[str, float]:
        """Put the robot where it began and return the readings; `rng` is not used unless the robot says so."""
        self._world.restoreState(self._beginning)
        self._stand_still()
        self._readings = self._sense()
        return self.readings

    @property
    def readings(self) -> dict[str, float]:
        """What the sensors say now, by the names and in the units of the robot's card."""
        return dict(self._readings)

    def act(self, command: Mapping[str, float]) -> dict[str, float]:
        """Carry out `command` for one control step and return the readings.

        Raises ValueError for an unknown name, a missing one, NaN, or a speed out of range.
        """
        self._card.check_command(command)
        self._drive(command)
        self._world.run(self._step_time)
        self._readings = self._sense()
        return self.readings


def transform(position: tuple[float, ...], quaternion: tuple[float, ...]) -> np.ndarray:
    """Homogeneous transform of a place [m] and a turn (x, y, z, w); array (4, 4)."""
    matrix = np.eye(4)
    matrix[:3, :3] = np.reshape(pybullet.getMatrixFromQuaternion(quaternion), (3, 3))
    matrix[:3, 3] = position
    return matrix


def quaternion_of(matrix: np.ndarray) -> tuple[float, ...]:
    """The turn (x, y, z, w) about the vertical in a homogeneous transform, array (4, 4)."""
    return pybullet.getQuaternionFromEuler((0, 0, float(np.arctan2(matrix[1, 0], matrix[0, 0]))))
