"""One of the toolkit's robots, served as if it were a real one behind rosbridge: for rehearsals and tests."""

import contextlib
import math
import queue
import threading
import time
from pathlib import Path
from typing import Any

from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.robots.realism import Realism
from rlrobot_edu.task.task import Task
from rlrobot_ros import messages
from rlrobot_ros.live.rosbridge import Rosbridge
from rlrobot_ros.live.rosbridge_server import RosbridgeServer
from rlrobot_ros.live.simulated_body import RANGE_MAX, TICK, SimulatedBody

WATCHDOG = 0.5  # a robot without a command for so long stops [s]
REPEAT = 0.2  # in simulated time, its messages are repeated after so long [s]


@suggests_keywords
class ServedRobot(contextlib.AbstractContextManager["ServedRobot"]):
    """The robot of a task, simulated by pymunk, behind rosbridge. It runs until `close`.

    Parameters
    ----------
    task : str, Path or Task
        The task of the robot, one on wheels, and of its scene.
    realism : Realism, optional
        Imperfections to simulate; a control step is a tenth of a second here.
    seed : int, optional
        Makes them repeatable, in simulated time.
    simulated_time : bool
        Time passes only with commands, a tenth of a second for each; otherwise it is that of the clock.
    port : int
        Port of rosbridge; 0 takes a free one.

    Raises
    ------
    ValueError
        If the task cannot be served, or if the port is not one.
    OSError
        If the port is taken, or if there is no such task file.

    Notes
    -----
    - It publishes ``odom`` and ``laser_scan``, and obeys ``cmd_vel``, whether of type Twist or TwistStamped.
    - It stops by itself after half a second without a command, as real ones should.
    - A command above what its wheels can do is reduced to that.
    - A link reaches it by its `address`: ``RobotLink(robot.address)``.
    """

    def __init__(
        self,
        task: str | Path | Task,
        *,
        realism: Realism | None = None,
        seed: int | None = None,
        simulated_time: bool = False,
        port: int = 9090,
    ) -> None:
        self._body = SimulatedBody(task, realism, seed)
        # Only once in each place: the number of messages must not change the random numbers.
        self._ranges = self._body.look()
        self._commands: queue.SimpleQueue[tuple[float, float]] = queue.SimpleQueue()
        self._simulated_time = simulated_time
        self._time = 1.0 if simulated_time else time.time()
        self._problem = ""
        self._ends = threading.Event()
        self._has_ended = threading.Event()
        with contextlib.ExitStack() as opened:
            self.address = opened.enter_context(RosbridgeServer(port)).address
            connection = Rosbridge(self.address)
            opened.callback(connection.close)
            self._publish_pose = connection.advertise("odom", messages.ODOMETRY)
            self._publish_scan = connection.advertise("laser_scan", messages.LASER_SCAN)
            connection.subscribe("cmd_vel", messages.TWIST, self._receive)
            self._opened = opened.pop_all()
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
        # Not thread.join: if Ctrl-C comes within it, Python 3.11 believes that the thread has ended.
        # On Windows, Ctrl-C is not heard in a longer wait.
        while not self._has_ended.wait(1.0):
            pass
        if self._problem:
            raise ConnectionError(self._problem)

    def close(self) -> None:
        """End the robot and its connection."""
        self._ends.set()
        self._thread.join()
        self._opened.close()

    def _receive(self, message: Any) -> None:
        """Take in a Twist; an impossible one is ignored."""
        with contextlib.suppress(ValueError):
            v, _, omega = messages.velocity_of(message)
            if math.isfinite(v) and math.isfinite(omega):
                self._commands.put((v, omega))

    def _run(self) -> None:
        """Live, in a thread of its own."""
        try:
            self._publish()
            if self._simulated_time:
                self._live_by_commands()
            else:
                self._live_by_the_clock()
        except ConnectionError as error:
            self._problem = str(error)
        finally:
            self._has_ended.set()

    def _live_by_commands(self) -> None:
        """Carry out each command for a tick; while there is none, publish the same again."""
        while not self._ends.is_set():
            with contextlib.suppress(queue.Empty):
                v, omega = self._commands.get(timeout=REPEAT)
                self._move(v, omega)
                self._time += TICK
            self._publish()

    def _live_by_the_clock(self) -> None:
        """Carry out the latest command, tick by tick, until it is too old."""
        command = (0.0, 0.0)
        received_at = -math.inf
        due = time.monotonic()
        while True:
            # Ticks that a busy computer has missed are skipped.
            due = max(due + TICK, time.monotonic())
            if self._ends.wait(max(due - time.monotonic(), 0.0)):
                return
            while not self._commands.empty():
                command = self._commands.get()
                received_at = time.monotonic()
            if time.monotonic() - received_at > WATCHDOG:
                command = (0.0, 0.0)
            self._move(*command)
            self._time = time.time()
            self._publish()

    def _move(self, v: float, omega: float) -> None:
        self._body.move(v, omega)
        self._ranges = self._body.look()

    def _publish(self) -> None:
        """Publish where the robot is and what its scanner sees."""
        pose = self._body.pose()
        self._publish_pose(messages.make_odometry(self._time, *pose))
        self._publish_scan(
            messages.make_laser_scan(self._time, self._ranges, RANGE_MAX)
        )
