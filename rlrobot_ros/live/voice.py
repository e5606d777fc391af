"""Telling a robot how to move, and that the last word is stop."""

import contextlib
import time

from rlrobot_ros.live.connection import Connection
from rlrobot_ros.messages import (
    TWIST,
    TWIST_STAMPED,
    make_twist,
    make_twist_stamped,
)


class Voice:
    """What is said to the robot over a connection, until `close`; a dry one says nothing at all.

    said: how many commands the robot was given, or would have been if it is dry
    """

    def __init__(
        self, connection: Connection, topic: str, stamped: bool, is_dry: bool = False
    ) -> None:
        self._send = (
            None
            if is_dry
            else connection.speak(topic, TWIST_STAMPED if stamped else TWIST)
        )
        self._make, self._stamped, self.said = connection.make, stamped, 0

    def say(self, v: float, omega: float) -> None:
        """Tell the robot to drive at v [m/s] and to turn to the left at omega [rad/s].

        Raises ConnectionError if the connection is lost.
        """
        self.said += 1
        self._tell(v, omega)

    def stop(self) -> None:
        """Tell the robot to stop, if it was ever told to do anything; where it cannot be reached, nothing happens."""
        if self.said:
            with contextlib.suppress(ConnectionError):
                self._tell(0.0, 0.0)

    def _tell(self, v: float, omega: float) -> None:
        twist = (
            make_twist_stamped(self._make, time.time(), v, omega)
            if self._stamped
            else make_twist(self._make, v, omega)
        )
        if self._send is not None:
            self._send(twist)
