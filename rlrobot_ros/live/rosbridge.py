"""A connection to rosbridge, which passes on the messages of ROS 1 or ROS 2: JSON over a websocket.

The protocol is rosbridge's version 2.0: https://github.com/RobotWebTools/rosbridge_suite
"""

import json
import logging
import re
import socket
import struct
import sys
import threading
from collections import deque
from collections.abc import Callable
from contextlib import ExitStack
from types import SimpleNamespace
from typing import Any

from rlrobot_edu.checks import describe_error

try:
    from websockets.exceptions import ConnectionClosed, WebSocketException
    from websockets.sync.client import connect
except ImportError:
    raise ImportError(
        "websockets is not installed: run pip install websockets; everything else works without it"
    ) from None

OPEN_TIMEOUT = 5.0  # until somebody answers [s]
CLOSE_TIMEOUT = 1.0  # until the other side has said goodbye, too [s]
SEND_TIMEOUT = 2  # until the other side takes something, once all buffers are full [s]
PING_INTERVAL = 5.0  # [s]
PING_TIMEOUT = 10.0  # [s]; a dead network is noticed within both together
LARGEST_MESSAGE = 2**24  # [bytes]
ERRORS = 5  # so many are kept
ADVICE = "is lost; see whether rosbridge and the network are up, then connect again"
ADDRESS = re.compile(r"wss?://[^\s/:]+:\d+(/\S*)?|wss?://\[[\da-fA-F:.]+\]:\d+(/\S*)?")

log = logging.getLogger(__name__)
log.addHandler(logging.NullHandler())  # `lost` says what is wrong, not the screen
# of both ends of a connection; in a local network, compression takes longer than it saves
OPTIONS: dict[str, Any] = {
    "compression": None,
    "open_timeout": OPEN_TIMEOUT,
    "close_timeout": CLOSE_TIMEOUT,
    "ping_interval": PING_INTERVAL,
    "ping_timeout": PING_TIMEOUT,
    "max_size": LARGEST_MESSAGE,
    "logger": log,
}


class Rosbridge:
    """A connection to rosbridge. A lost one does not come back by itself: make a new one.

    address: of rosbridge, such as "ws://192.168.0.10:9090"
    lost: why no more messages come or go, in words; None while all is well
    errors: the latest errors that rosbridge reported, or that its messages caused

    Raises ValueError if the address is not one, ConnectionError if no rosbridge answers there within 5 s.
    """

    def __init__(self, address: str = "ws://127.0.0.1:9090") -> None:
        if not ADDRESS.fullmatch(str(address)):
            raise ValueError(
                "the address of rosbridge must be ws://, the robot's name or number, a colon and the port, as in "
                f"'ws://192.168.0.10:9090', got {address!r:.200}"
            )
        self.address = address
        self.lost: str | None = None
        self.errors: deque[str] = deque(maxlen=ERRORS)
        self._callbacks: dict[str, Callable[[Any], None]] = {}
        try:
            self._socket = _opened(address)
        # ValueError: a name or a port that cannot be
        except (OSError, EOFError, ValueError, WebSocketException) as error:
            raise ConnectionError(
                f"no rosbridge answers at {address} ({describe_error(error)}); is it running on the robot? "
                "Start it with "
                "roslaunch rosbridge_server rosbridge_websocket.launch (ROS 1) or "
                "ros2 launch rosbridge_server rosbridge_websocket_launch.xml (ROS 2)"
            ) from None
        self._thread = threading.Thread(
            target=self._listen, name=f"rosbridge {address}", daemon=True
        )
        self._thread.start()

    def subscribe(self, topic: str, kind: str, callback: Callable[[Any], None]) -> None:
        """From now on call `callback` with each message of this topic, in the connection's own thread."""
        self._callbacks[topic] = callback
        self._send(
            op="subscribe", topic=topic, type=kind, queue_length=1, throttle_rate=0
        )

    def advertise(self, topic: str, kind: str) -> Callable[[dict[str, Any]], None]:
        """A function that publishes a message on this topic. It raises ConnectionError if the connection is lost."""
        self._send(op="advertise", topic=topic, type=kind)
        return lambda message: self._send(op="publish", topic=topic, msg=message)

    def close(self) -> None:
        """End it within about 2 s; what was sent before still goes out. No message comes after that."""
        self._lose("was closed here")
        self._socket.close()
        if threading.current_thread() is not self._thread:
            self._thread.join(CLOSE_TIMEOUT)

    def _send(self, **request: Any) -> None:
        if self.lost is None:
            try:
                self._socket.send(json.dumps(request))
                return
            except ConnectionClosed as error:
                self._lose(f"{ADVICE} ({error})")
        raise ConnectionError(self.lost)

    def _lose(self, why: str) -> None:
        if self.lost is None:
            self.lost = f"the connection to rosbridge at {self.address} {why}"

    def _listen(self) -> None:
        """Receive messages until the end, in a thread of its own."""
        try:
            while self.lost is None:
                # As bytes, so that an error of UTF-8 does not end the connection.
                text = self._socket.recv(decode=False)
                if self.lost is None:
                    self._receive(text)
        except ConnectionClosed as error:
            self._lose(f"{ADVICE} ({error})")

    def _receive(self, text: bytes) -> None:
        """Give a message to the callback of its topic. It never raises, whatever the message is."""
        try:
            received = json.loads(text, object_hook=_with_attributes)
            if received.op == "publish":
                self._callbacks[received.topic](received.msg)
            elif received.op == "status" and received.level == "error":
                self.errors.append(f"{received.msg!s:.500}")
        except Exception as error:  # the next message may be better
            self.errors.append(describe_error(error))


def _opened(address: str) -> Any:
    """An open websocket."""
    opening = connect(address, proxy=None, **OPTIONS)
    # In this way all versions of websockets can keep a connection open beyond a block.
    opened = ExitStack().enter_context(opening)
    # A sender must not wait for ever for a robot that has stopped reading.
    if sys.platform == "win32":
        timeout = struct.pack("I", SEND_TIMEOUT * 1000)
    else:
        timeout = struct.pack("ll", SEND_TIMEOUT, 0)
    opened.socket.setsockopt(socket.SOL_SOCKET, socket.SO_SNDTIMEO, timeout)
    return opened


def _with_attributes(fields: dict[str, Any]) -> SimpleNamespace:
    return SimpleNamespace(**fields)
