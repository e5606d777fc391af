"""An open connection to one robot: its sensors, its controller and its guardian."""

import threading
from dataclasses import dataclass

from rlrobot_edu.robots.chassis import Chassis
from rlrobot_edu.task.task import Task
from rlrobot_ros.live.controller import PERIOD, Controller, Limits
from rlrobot_ros.live.guardian import Guardian
from rlrobot_ros.live.link_report import LinkReport
from rlrobot_ros.live.rosbridge import Rosbridge
from rlrobot_ros.live.safety import confirm
from rlrobot_ros.live.sensors import Sensors
from rlrobot_ros.live.velocity_publisher import VelocityPublisher
from rlrobot_ros.messages import LASER_SCAN, ODOMETRY
from rlrobot_ros.scan import Mounting


@dataclass(frozen=True)
class Settings:
    """How to reach a robot, and what it may do: see `RobotLink`."""

    address: str
    odom: str
    scan: str
    cmd_vel: str
    stamped: bool
    mounting: Mounting
    limits: Limits
    confirmed: bool
    dry_run: bool
    simulated_time: bool


class Session:
    """A connection that is open until `close`. The last command to the robot is stop.

    Raises what `Rosbridge` raises.
    """

    def __init__(self, settings: Settings, chassis: Chassis) -> None:
        self._settings = settings
        self.connection = Rosbridge(settings.address)
        self.sensors = Sensors(chassis, settings.mounting, settings.odom, settings.scan)
        try:
            self._velocity = VelocityPublisher(
                self.connection, settings.cmd_vel, settings.stamped, settings.dry_run
            )
            self.connection.subscribe(
                settings.odom, ODOMETRY, self.sensors.receive_odometry
            )
            self.connection.subscribe(
                settings.scan, LASER_SCAN, self.sensors.receive_scan
            )
        except BaseException:
            self.connection.close()
            raise
        self._controller = Controller(
            self.connection,
            self.sensors,
            self._velocity,
            settings.limits,
            settings.simulated_time,
        )
        self._may_move = settings.dry_run
        self._guardian: Guardian | None = None
        self._idle = threading.Timer(0.0, self.stop)

    def begin(self, task: Task) -> None:
        """Stop the robot and wait for new messages. Raises ConnectionError or TimeoutError if there are none.

        Raises ValueError if the task needs a laser that the scanner cannot replace.
        """
        self.stop()
        self.sensors.forget()
        self._controller.wait()
        self.sensors.expect(task)
        self._controller.wait()

    def drive(self, v: float, omega: float, seconds: float) -> None:
        """Drive at v [m/s] and turn at omega [rad/s] for some time; then stop, unless driving goes on within 0.1 s.

        Raises PermissionError if nobody has said that the robot may move, ConnectionError or TimeoutError if it is
        lost. An exception stops the robot.
        """
        if (v or omega) and not self._may_move:
            self._get_leave()
        self._idle.cancel()
        try:
            self._controller.drive(v, omega, seconds)
        except BaseException:
            self.stop()
            if self.connection.lost is not None:
                # the guardian has a connection of its own and may still reach the robot
                self.close()
            raise
        if not self._settings.simulated_time:  # there nothing moves without a command
            self._idle = threading.Timer(PERIOD, self.stop)
            self._idle.daemon = True
            self._idle.start()

    def _get_leave(self) -> None:
        """Ask the person, and start the guardian."""
        settings = self._settings
        if not settings.confirmed:
            confirm(
                f"The robot behind {settings.address} will move by itself, at up to {settings.limits.max_speed:g} m/s. "
                "Is the floor around it free, and your hand at its emergency stop?"
            )
        if not settings.simulated_time:
            self._guardian = Guardian(
                settings.address, settings.cmd_vel, settings.stamped
            )
        self._may_move = True

    def stop(self) -> None:
        """Tell the robot to stop, if it was ever told to move."""
        self._idle.cancel()
        self._velocity.stop()

    def close(self) -> None:
        """Stop the robot and end the connection, and with it all that was started. It may be called again."""
        self.stop()
        self.connection.close()
        if self._guardian is not None:
            self._guardian.close()

    def report(self) -> LinkReport:
        """What was received and sent so far."""
        pose = self.sensors.pose
        sight = self.sensors.sight
        return LinkReport(
            address=self._settings.address,
            is_dry=self._settings.dry_run,
            odometry=pose.received,
            scans=sight.received,
            not_new=pose.dropped + sight.dropped,
            unreadable=self.sensors.unreadable,
            complaint=self.sensors.complaint,
            commands=self._velocity.commands,
            held_back=self._controller.held_back,
            pauses=self._controller.pauses,
            why=self._controller.why,
        )
