"""A simulation in PyBullet (three-dimensional physics): its clock, and the bodies in it."""

import os
import sys
import weakref
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from rlrobot_edu.installing import to_install
from rlrobot_edu.robots.scene import Solid, pose


@contextmanager
def _quiet_stderr() -> Iterator[None]:
    """Discard what C code writes to stderr (file descriptor 2) inside the block."""
    sys.stderr.flush()
    kept = os.dup(2)
    with open(os.devnull, "wb") as nothing:
        os.dup2(nothing.fileno(), 2)
    try:
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)


try:
    with _quiet_stderr():
        import pybullet
except ImportError:
    raise ImportError(
        "PyBullet is not installed; with Python 3.11 to 3.13 on Linux x86-64, Windows or macOS "
        f"it comes with {to_install('arm')}"
    ) from None

GRAVITY = 9.81  # [m/s²]
# Groups of bodies, which decide what collides with what
_FIXED, _FLOOR, _ROBOT = 2, 64, 128


class BulletSimulation:
    """A simulation without a window, for one robot alone; it has all functions of PyBullet, which act on it.

    physics_hz: physics steps a second [1/s]

    The simulation ends with `close`, or when it is no longer used.
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
            collisionFilterMode=0,  # two bodies collide only if each has the other's group in its mask
        )

    # pybullet_utils.bullet_client does the same, but prints a line each time that it connects.
    def __getattr__(self, name: str) -> Any:
        """PyBullet's function or constant of this name; the function acts on this simulation."""
        value = getattr(pybullet, name)
        if callable(value):
            value = partial(value, physicsClientId=self._client)
        self.__dict__[name] = value
        return value

    def run(self, seconds: float) -> None:
        """Let time pass."""
        for _ in range(max(1, round(seconds * self._hz))):
            self.stepSimulation()

    def state(self) -> bytes:
        """The places and velocities of all bodies now, for `resume`. PyBullet itself only writes them to a file."""
        with TemporaryDirectory() as folder:
            file = Path(folder, "state.bullet")
            self.saveBullet(str(file))
            return file.read_bytes()

    def resume(self, state: bytes) -> None:
        """Go on, to the last bit, from the `state` of a simulation that was built in the same way."""
        with TemporaryDirectory() as folder:
            file = Path(folder, "state.bullet")
            file.write_bytes(state)
            self.restoreState(fileName=str(file))

    def load(
        self,
        urdf: str | Path,
        position: tuple[float, float, float],
        yaw: float = 0.0,
        fixed: bool = False,
    ) -> int:
        """Put the robot that a URDF file describes at a place [m, rad]; returns the number of its body."""
        turned = self.getQuaternionFromEuler((0, 0, yaw))
        inertia = self.URDF_USE_INERTIA_FROM_FILE
        body: int = self.loadURDF(
            str(urdf), position, turned, useFixedBase=fixed, flags=inertia
        )
        for link in range(-1, self.getNumJoints(body)):
            self.setCollisionFilterGroupMask(body, link, _ROBOT, _FIXED | _FLOOR)
        return body

    def add(self, solid: Solid) -> int:
        """Put a box or a cylinder, which nothing can move, to its place; returns the number of its body."""
        if solid.shape == "box":
            half = [length / 2 for length in solid.size]
            shape = self.createCollisionShape(self.GEOM_BOX, halfExtents=half)
        else:
            radius, height = solid.size
            shape = self.createCollisionShape(
                self.GEOM_CYLINDER, radius=radius, height=height
            )
        yaw = float(np.arctan2(solid.pose[1, 0], solid.pose[0, 0]))
        turn = self.getQuaternionFromEuler((0, 0, yaw))
        # With "maximal coordinates" it is a plain rigid body, which takes less time in each step than a robot.
        body: int = self.createMultiBody(
            0, shape, -1, solid.pose[:3, 3].tolist(), turn, useMaximalCoordinates=1
        )
        self.setCollisionFilterGroupMask(body, -1, _FIXED, _ROBOT)
        return body

    def add_floor(self) -> int:
        """Put a wide floor, its top at z = 0; returns the number of its body."""
        floor = self.add(Solid("floor", "box", (40, 40, 1), pose(0, 0, -0.5), "wall"))
        self.setCollisionFilterGroupMask(floor, -1, _FLOOR, _ROBOT)
        return floor

    def floor_only(self, body: int, link: int) -> None:
        """Let this link of a robot collide with the floor and nothing else."""
        self.setCollisionFilterGroupMask(body, link, _ROBOT, _FLOOR)

    def joints(self, body: int) -> dict[str, int]:
        """Number of each joint, and so of the link it carries, by the joint's name."""
        return {
            self.getJointInfo(body, i)[1].decode(): i
            for i in range(self.getNumJoints(body))
        }

    def link_pose(self, body: int, link: int) -> np.ndarray:
        """Homogeneous transform of a link's frame, −1 for the base; array (4, 4) [m]."""
        if link == -1:
            return transform(*self.getBasePositionAndOrientation(body))
        state = self.getLinkState(body, link, computeForwardKinematics=True)
        position, quaternion = state[4:6]
        return transform(position, quaternion)


def transform(position: tuple[float, ...], quaternion: tuple[float, ...]) -> np.ndarray:
    """Homogeneous transform of a place [m] and a turn (x, y, z, w); array (4, 4)."""
    matrix = np.eye(4)
    matrix[:3, :3] = np.reshape(pybullet.getMatrixFromQuaternion(quaternion), (3, 3))
    matrix[:3, 3] = position
    return matrix
