"""One of the toolkit's own robots as if it were a real one that speaks ROS: to rehearse, and to test with."""

import contextlib
import math
import queue
import threading
import time
from pathlib import Path
from typing import Any

from rlrobot_edu.robots.realism import Realism
from rlrobot_edu.task.robot_cards import LASER_RANGE
from rlrobot_edu.task.task import Task
from rlrobot_ros import messages
from rlrobot_ros.live.connection import connect
from rlrobot_ros.live.rosbridge_router import RosbridgeRouter
from rlrobot_ros.live.served_body import TICK, ServedBody

WATCHDOG = 0.5  # a robot without a command for so long stops [s]
REPEAT = (
    0.2  # where simulated time stands still, what is so is said again after so long [s]
)


class ServedRobot(contextlib.AbstractContextManager["ServedRobot"]):
    """The robot of a task, simulated by pymunk, behind ROS. It runs until `close`.

    Parameters
    ----------
    body : str, Path, Task or ServedBody
        The task of the robot, one on wheels, and of its scene; or a body that exists already.
    link : str
        ``rosbridge`` brings what speaks its protocol along; ``dds`` needs nothing more.
    realism : Realism, optional
        Weaknesses that the robot shall have; its control steps are tenths of a second here.
    seed : int, optional
        Makes them repeatable, in simulated time.
    simulated_time : bool
        Each command takes the robot a tenth of a second on, and nothing else does; else its time is the clock's.
    odom, scan, cmd_vel : str
        Names of the topics, the last of type Twist.
    stamped : bool
        Whether it hears TwistStamped instead.
    port : int
        Of rosbridge; 0 is one that is free.
    **where
        For the other links: ``domain``, ``interface``, ``peers`` or ``master``.

    Raises
    ------
    ValueError
        For a task that cannot be served, or an unknown link.
    OSError
        If the port is taken, nobody is there, or there is no such task file.

    Notes
    -----
    - The robot stops by itself after half a second without a command, as real ones should.
    - A command above what its wheels can do is reduced to that.
    - `where` is how a link reaches it: ``rl.RobotLink(link, **robot.where)``.
    """

    def __init__(
        self,
        body: str | Path | Task | ServedBody,
        link: str = "rosbridge",
        *,
        realism: Realism | None = None,
        seed: int | None = None,
        simulated_time: bool = False,
        odom: str = "odom",
        scan: str = "laser_scan",
        cmd_vel: str = "cmd_vel",
        stamped: bool = False,
        port: int = 9090,
        **where: Any,
    ) -> None:
        self._body = (
            body if isinstance(body, ServedBody) else ServedBody(body, realism, seed)
        )
        self._ranges = (
            self._body.look()
        )  # once where it stands: how often it is said must not cost random numbers
        self._told: queue.SimpleQueue[tuple[float, float]] = queue.SimpleQueue()
        self._time = 1.0 if simulated_time else time.time()
        self._is_simulated, self._problem = simulated_time, ""
        self._ends, self._has_ended = threading.Event(), threading.Event()
        with contextlib.ExitStack() as opened:
            if link == "rosbridge":
                where["address"] = opened.enter_context(RosbridgeRouter(port)).address
            connection = connect(link, **where)
            opened.callback(connection.close)
            self._make = connection.make
            self._say_pose = connection.speak(odom, messages.ODOMETRY)
            self._say_scan = connection.speak(scan, messages.LASER_SCAN)
            connection.hear(
                cmd_vel,
                messages.TWIST_STAMPED if stamped else messages.TWIST,
                self._hear,
            )
            self._opened = opened.pop_all()
        self.where = where
        self.way = f"{link} at {where['address']}" if "address" in where else link
        self._thread = threading.Thread(
            target=self._run, name="served robot", daemon=True
        )
        self._thread.start()

    def __exit__(self, *error: object) -> None:
        self.close()

    def wait(self) -> None:
        """Return when the robot has ended; it does not end by itself.

        Raises
        ------
        ConnectionError
            If it is cut off.
        """
        # not thread.join: Python 3.11 takes the thread for ended when Ctrl-C comes within it
        while not self._has_ended.wait(
            1.0
        ):  # on Windows, Ctrl-C is not heard in a longer wait
            pass
        if self._problem:
            raise ConnectionError(self._problem)

    def close(self) -> None:
        """End the robot and its connection."""
        self._ends.set()
        self._thread.join()
        self._opened.close()

    def _hear(self, message: Any) -> None:
        """Take in a Twist; one that says nothing that can be is not obeyed."""
        with contextlib.suppress(ValueError):
            v, _, omega = messages.velocity_of(message)
            if math.isfinite(v) and math.isfinite(omega):
                self._told.put((v, omega))

    def _run(self) -> None:
        """Live, in a thread of its own."""
        try:
            self._say()
            (self._live_when_told if self._is_simulated else self._live_by_the_clock)()
        except ConnectionError as error:
            self._problem = str(error)
        finally:
            self._has_ended.set()

    def _live_when_told(self) -> None:
        """Carry out each command for a tick; while there is none, say again what is so."""
        while not self._ends.is_set():
            with contextlib.suppress(queue.Empty):
                self._move(*self._told.get(timeout=REPEAT))
                self._time += TICK
            self._say()

    def _live_by_the_clock(self) -> None:
        """Carry out the latest command, tick by tick, until it is too old."""
        told, said_at = (0.0, 0.0), -math.inf
        due = time.monotonic()
        while True:
            due = max(
                due + TICK, time.monotonic()
            )  # ticks that a busy computer has missed are not made up for
            if self._ends.wait(max(due - time.monotonic(), 0.0)):
                return
            while not self._told.empty():
                told, said_at = self._told.get(), time.monotonic()
            self._move(
                *(told if time.monotonic() - said_at <= WATCHDOG else (0.0, 0.0))
            )
            self._time = time.time()
            self._say()

    def _move(self, v: float, omega: float) -> None:
        self._body.move(v, omega)
        self._ranges = self._body.look()

    def _say(self) -> None:
        """Tell where the robot is and what its scanner sees."""
        self._say_pose(
            messages.make_odometry(self._make, self._time, *self._body.pose())
        )
        self._say_scan(
            messages.make_laser_scan(
                self._make, self._time, self._ranges, 2 * LASER_RANGE
            )
        )
