"""An open connection to one robot, with all that hears it, speaks to it and guards it."""

import threading
from dataclasses import dataclass
from typing import Any

from rlrobot_edu.robots.chassis import Chassis
from rlrobot_edu.task.task import Task
from rlrobot_ros.live.connection import connect
from rlrobot_ros.live.guardian import Guardian
from rlrobot_ros.live.link_report import LinkReport
from rlrobot_ros.live.safety import confirm
from rlrobot_ros.live.senses import Senses
from rlrobot_ros.live.steering import PERIOD, Limits, Steering
from rlrobot_ros.live.voice import Voice
from rlrobot_ros.messages import LASER_SCAN, ODOMETRY
from rlrobot_ros.scan import Mounting


@dataclass(frozen=True)
class Settings:
    """How a robot is reached, and what it may do: see `RobotLink`."""

    link: str
    where: dict[str, Any]
    odom: str
    scan: str
    cmd_vel: str
    stamped: bool
    mounting: Mounting
    limits: Limits
    confirmed: bool
    dry_run: bool
    simulated_time: bool


class Line:
    """A connection that is open until `close`. Its last word to the robot is stop.

    Raises what `connect` raises.
    """

    def __init__(self, settings: Settings, chassis: Chassis) -> None:
        self._settings = settings
        self.connection = connect(settings.link, **settings.where)
        self.senses = Senses(chassis, settings.mounting, settings.odom, settings.scan)
        try:
            self._voice = Voice(
                self.connection, settings.cmd_vel, settings.stamped, settings.dry_run
            )
            self.connection.hear(settings.odom, ODOMETRY, self.senses.hear_odometry)
            self.connection.hear(settings.scan, LASER_SCAN, self.senses.hear_scan)
        except BaseException:
            self.connection.close()
            raise
        self._steering = Steering(
            self.connection,
            self.senses,
            self._voice,
            settings.limits,
            settings.simulated_time,
        )
        self._may_move = settings.dry_run
        self._guardian: Guardian | None = None
        self._idle = threading.Timer(0.0, self.stop)

    def begin(self, task: Task) -> None:
        """Stop the robot and wait until it is heard anew. Raises ConnectionError or TimeoutError if it is not.

        Raises ValueError if the task needs a laser that the scanner cannot stand for.
        """
        self.stop()
        self.senses.forget()
        self._steering.wait()
        self.senses.expect(task)
        self._steering.wait()

    def drive(self, v: float, omega: float, seconds: float) -> None:
        """Drive at v [m/s] and turn at omega [rad/s] for a while; then stop, unless one drives on within 0.1 s.

        Raises PermissionError if nobody has said that the robot may move, ConnectionError or TimeoutError if it is
        lost. An exception stops the robot.
        """
        if (v or omega) and not self._may_move:
            self._get_leave()
        self._idle.cancel()
        try:
            self._steering.drive(v, omega, seconds)
        except BaseException:
            self.stop()
            if self.connection.lost is not None:
                self.close()  # the guardian has a connection of its own and may still reach the robot
            raise
        if (
            not self._settings.simulated_time
        ):  # there, nothing moves while nothing is said
            self._idle = threading.Timer(PERIOD, self.stop)
            self._idle.daemon = True
            self._idle.start()

    def _get_leave(self) -> None:
        """Ask the person, and have somebody watch over the robot."""
        settings = self._settings
        if not settings.confirmed:
            confirm(
                f"The robot behind {settings.link} will move by itself, at up to {settings.limits.max_speed:g} m/s. "
                "Is the floor around it free, and your hand at its emergency stop?"
            )
        if not settings.simulated_time:
            self._guardian = Guardian(
                settings.link, settings.where, settings.cmd_vel, settings.stamped
            )
        self._may_move = True

    def stop(self) -> None:
        """Tell the robot to stop, if it was ever told to move."""
        self._idle.cancel()
        self._voice.stop()

    def close(self) -> None:
        """Stop the robot and end the connection, and with it all that was started. It may be called again."""
        self.stop()
        self.connection.close()
        if self._guardian is not None:
            self._guardian.close()

    def report(self) -> LinkReport:
        """What was heard and said so far."""
        return LinkReport(
            self._settings.link, self._settings.dry_run, self.senses.pose.heard, self.senses.sight.heard,
            self.senses.pose.dropped + self.senses.sight.dropped, self.senses.unreadable, self.senses.complaint,
            self._voice.said, self._steering.held_back, self._steering.pauses, self._steering.why,
        )  # fmt: skip
