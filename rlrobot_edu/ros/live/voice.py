"""Telling a robot how to move, and that the last word is stop."""

import contextlib
import time
from collections.abc import Callable

from rlrobot_edu.ros.live.connection import Connection
from rlrobot_edu.ros.messages import TWIST, TWIST_STAMPED, make_twist, make_twist_stamped


def voice(connection: Connection, topic: str, stamped: bool) -> Callable[[float, float], None]:
    """A function that tells the robot to drive at v [m/s] and to turn to the left at omega [rad/s].

    It raises ConnectionError if the connection is lost.
    """
    say, make = connection.speak(topic, TWIST_STAMPED if stamped else TWIST), connection.make

    def tell(v: float, omega: float) -> None:
        say(make_twist_stamped(make, time.time(), v, omega) if stamped else make_twist(make, v, omega))

    return tell


class Voice:
    """What is said to the robot over a connection, until `close`; a dry one says nothing at all.

    said: how many commands the robot was given, or would have been if it is dry
    """

    def __init__(self, connection: Connection, topic: str, stamped: bool, is_dry: bool) -> None:
        self._tell = None if is_dry else voice(connection, topic, stamped)
        self.said = 0

    def say(self, v: float, omega: float) -> None:
        """Tell the robot to drive at v [m/s] and to turn to the left at omega [rad/s].

        Raises ConnectionError if the connection is lost.
        """
        self.said += 1
        if self._tell is not None:
            self._tell(v, omega)

    def stop(self) -> None:
        """Tell the robot to stop, if it was ever told to do anything; where it cannot be reached, nothing happens."""
        if self._tell is not None and self.said:
            with contextlib.suppress(ConnectionError):
                self._tell(0.0, 0.0)
