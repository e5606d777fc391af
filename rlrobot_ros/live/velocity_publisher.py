"""Publishing velocity commands, of which the last is stop."""

import contextlib

from rlrobot_ros.live.rosbridge import Rosbridge
from rlrobot_ros.messages import TWIST, TWIST_STAMPED, make_twist, make_twist_stamped


class VelocityPublisher:
    """Publishes a Twist, or a TwistStamped if `stamped`, on a topic; in a dry run it publishes nothing.

    commands: how many the robot received, or would have received without the dry run
    """

    def __init__(
        self, connection: Rosbridge, topic: str, stamped: bool, is_dry: bool = False
    ) -> None:
        kind = TWIST_STAMPED if stamped else TWIST
        self._publish = None if is_dry else connection.advertise(topic, kind)
        self._make = make_twist_stamped if stamped else make_twist
        self.commands = 0

    def publish(self, v: float, omega: float) -> None:
        """Tell the robot to drive at v [m/s] and to turn to the left at omega [rad/s].

        Raises ConnectionError if the connection is lost.
        """
        self.commands += 1
        self._send(v, omega)

    def stop(self) -> None:
        """Stop the robot, if it ever received a command; do nothing if it cannot be reached."""
        if self.commands:
            with contextlib.suppress(ConnectionError):
                self._send(0.0, 0.0)

    def _send(self, v: float, omega: float) -> None:
        if self._publish is not None:
            self._publish(self._make(v, omega))
