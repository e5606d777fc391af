"""A real robot that is switched on, as a robot of the toolkit."""

import math
import weakref
from collections.abc import Mapping
from typing import NoReturn

import numpy as np

from rlrobot_edu.checks import check_text
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.robots.chassis import Chassis, laser_beams
from rlrobot_edu.robots.robot import Robot
from rlrobot_edu.robots.scene import Scene, Solid, pose
from rlrobot_edu.task.robot_cards import LASER_RANGE, LASERS, ROBOTS
from rlrobot_edu.task.task import Task
from rlrobot_ros.live.controller import Limits
from rlrobot_ros.live.link_report import LinkReport
from rlrobot_ros.live.safety import within
from rlrobot_ros.live.session import Session, Settings
from rlrobot_ros.motions import chassis_of
from rlrobot_ros.scan import Mounting


@suggests_keywords
class RobotLink(Robot):
    """A real robot with ROS 1 or ROS 2 behind rosbridge. `rl.make_env(task, link=…)` makes its environment.

    Parameters
    ----------
    address : str
        Of rosbridge: ws://, the robot's name or number, a colon and the port.
    odom, scan, cmd_vel : str
        Names of the topics: of type Odometry, LaserScan, and Twist.
    stamped : bool
        Whether the robot wants TwistStamped instead of Twist.
    chassis : Chassis, optional
        Wheels and body of the robot; None takes those of the task's robot.
    mounting : tuple of float, float, float, bool, float
        Where the scanner is: how far ahead of the point midway between the wheels and to its left [m], the direction
        of its angle 0 to the left from straight ahead [rad], and whether it hangs upside down. A fifth value is the one
        that it gives where nothing is within its range, if not infinity: 0, NaN, or any number above its range_max.
    max_speed, max_turn : float [m/s], [rad/s]
        Limits that no command exceeds.
    safety_distance : float [m]
        No forward motion while something ahead is nearer than this to the circle around the robot, or nearer than it
        gets at this speed before it stands: if its scan is half a second old, its commands act 0.3 s late and it brakes
        by 0.5 m/s². From 0.18 m/s that is 0.18 m, from 0.25 m/s 0.26 m.
    confirmed : bool
        Whether the robot may move at once; otherwise a person is asked before its first motion.
    dry_run : bool
        Send nothing to the robot, only listen; `report` counts what would have been sent.
    simulated_time : bool
        For a simulated robot whose time passes only with its commands (``serve-robot --simulated-time``).

    Raises
    ------
    ValueError
        For a limit that is not a positive number, or arguments that do not fit together.

    Notes
    -----
    - A step sends its command ten times a second for the task's `step_time`. It is followed by a stop, unless the next
      step comes within a tenth of a second.
    - Anything that ends a step early, such as an exception or Ctrl-C, stops the robot, and so does `close`. If this
      process is killed, or does not run for half a second, a second one stops it.
    - While odometry or scan is older than half a second, or the scan does not say what is ahead, the robot is stopped
      and the step waits, up to ten seconds; `report` says why. A scan counts only if it shows all lasers that the task
      needs, and all that it showed at `reset`.
    - `reset` does not move the robot: it stops it and waits for its messages.
    """

    def __init__(
        self,
        address: str = "ws://127.0.0.1:9090",
        *,
        odom: str = "odom",
        scan: str = "laser_scan",
        cmd_vel: str = "cmd_vel",
        stamped: bool = False,
        chassis: Chassis | None = None,
        mounting: tuple[float, ...] = Mounting(),
        max_speed: float = 0.18,
        max_turn: float = 1.0,
        safety_distance: float = 0.18,
        confirmed: bool = False,
        dry_run: bool = False,
        simulated_time: bool = False,
    ) -> None:
        texts = {"address": address, "odom": odom, "scan": scan, "cmd_vel": cmd_vel}
        for name, text in texts.items():
            check_text(name, text)
        if chassis is not None and not isinstance(chassis, Chassis):
            raise ValueError(
                f"chassis must be None or an rlrobot_edu.robots.chassis.Chassis, got {chassis!r:.200}"
            )
        limits = Limits(max_speed, max_turn, safety_distance)
        for name, limit in limits._asdict().items():
            is_number = isinstance(limit, int | float | np.number)
            if not (is_number and 0 < limit < math.inf):
                raise ValueError(
                    f"{name} must be a positive number, got {limit!r:.200}"
                )
        if dry_run and simulated_time:
            raise ValueError(
                "in a dry run no simulated time would pass: choose dry_run or simulated_time"
            )
        self._own_chassis = chassis
        self._task: Task | None = None
        self._session: Session | None = None
        self._last_report: LinkReport | None = None  # once the link has been closed
        self._settings = Settings(
            address=address,
            odom=odom,
            scan=scan,
            cmd_vel=cmd_vel,
            stamped=stamped,
            mounting=Mounting.of(mounting),
            limits=limits,
            confirmed=confirmed,
            dry_run=dry_run,
            simulated_time=simulated_time,
        )

    def __getstate__(self) -> NoReturn:
        raise TypeError(
            "a link to a robot can be neither copied nor sent to another process: there is one robot"
        )

    def prepare(self, task: Task) -> None:
        """Get ready for a task; nothing is sent yet.

        Parameters
        ----------
        task : Task
            The robot's task.

        Raises
        ------
        ValueError
            If the task's robot has no wheels, or if one of its actions is above the limits.
        """
        chassis = self._own_chassis or chassis_of(task)
        limits = self._settings.limits
        for a in range(task.actions.n):
            v, omega = chassis.twist(task.command_for(a))
            if within(v, omega, limits.max_speed, limits.max_turn) != (v, omega):
                raise ValueError(
                    f"{task.path}: action {a} drives at {v:.3g} m/s and turns at {omega:.3g} rad/s, above the limits "
                    f"of {limits.max_speed:g} m/s and {limits.max_turn:g} rad/s; choose slower outputs or, if that is "
                    "safe, RobotLink(…, max_speed=, max_turn=)"
                )
        self.close()
        self._task = task
        self._chassis = chassis

    @property
    def readings(self) -> dict[str, float]:
        """The sensors' readings now, by name.

        Raises
        ------
        ConnectionError
            Before the first `reset`.
        """
        return self._open_session().sensors.readings

    @property
    def report(self) -> LinkReport:
        """What was received and sent since the link was opened, also after `close`.

        Raises
        ------
        ConnectionError
            Before the first `reset`.
        """
        return self._last_report or self._open_session().report()

    def reset(self, rng: np.random.Generator | None = None) -> dict[str, float]:
        """Stop the robot, connect to it if necessary, and wait for its messages. It stays where it is.

        Parameters
        ----------
        rng : numpy.random.Generator, optional
            Not used; a real robot has no random numbers.

        Returns
        -------
        dict of str to float
            The readings.

        Raises
        ------
        OSError
            If nothing answers (ConnectionError), or if no messages of the robot come in time (TimeoutError).
        ValueError
            If the task needs a laser where the scanner does not look, or if the address is not one.
        """
        if self._task is None:
            raise ValueError(
                "give the link to an environment: rl.make_env(task, link=…)"
            )
        if self._session is not None and self._session.connection.lost is not None:
            self.close()
        if self._session is None:
            self._session = Session(self._settings, self._chassis)
            self._last_report = None
            # also when Python ends
            self._end = weakref.finalize(self, self._session.close)
        self._session.begin(self._task)
        return self.readings

    def act(self, command: Mapping[str, float]) -> dict[str, float]:
        """Drive for one control step. An exception stops the robot.

        Parameters
        ----------
        command : dict of str to float
            Speed of each wheel [rad/s].

        Returns
        -------
        dict of str to float
            The readings.

        Raises
        ------
        ValueError
            For a command that is not on the robot's card.
        OSError
            If nobody has confirmed that the robot may move (PermissionError), or if the robot is lost (ConnectionError,
            TimeoutError).
        """
        session = self._open_session()
        assert self._task is not None
        ROBOTS[self._task.robot].check_command(command)
        v, omega = self._chassis.twist(command)
        session.drive(v, omega, self._task.step_time)
        return self.readings

    def scene(self) -> Scene:
        """The robot at the place of its odometry, with its laser beams; the walls are unknown.

        Returns
        -------
        Scene
            The robot and its beams.

        Raises
        ------
        ConnectionError
            Before the first `reset`.
        """
        # An unknown beam shows no free space.
        readings = dict.fromkeys(LASERS, 0.0) | self.readings
        x, y = readings["x"], readings["y"]
        here = pose(x, y, 0.0, readings["theta"])
        front = here @ pose(self._chassis.radius - 0.075, 0, 0.26)
        solids = (
            Solid(
                "robot/body", *self._chassis.body(), here @ pose(0, 0, 0.16), "robot"
            ),
            Solid("robot/nose", "box", (0.14, 0.06, 0.04), front, "robot"),
        )
        bounds = (x - LASER_RANGE, y - LASER_RANGE, x + LASER_RANGE, y + LASER_RANGE)
        return Scene(solids, laser_beams(readings, self._chassis), bounds)

    def close(self) -> None:
        """Stop the robot and end the connection; `reset` connects again."""
        if self._session is not None:
            self._last_report = self._session.report()
            self._session = None
            self._end()

    def _open_session(self) -> Session:
        if self._session is None:
            raise ConnectionError("the link is not open: call env.reset() first")
        return self._session
