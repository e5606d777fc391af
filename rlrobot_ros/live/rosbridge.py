"""A way to a robot over rosbridge, of ROS 1 or ROS 2: JSON over a websocket.

The words that go over it are those of rosbridge's protocol 2.0: https://github.com/RobotWebTools/rosbridge_suite
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
from rlrobot_ros.messages import TWIST_STAMPED

try:
    from websockets.exceptions import ConnectionClosed, WebSocketException
    from websockets.sync.client import connect
except ImportError:
    raise ImportError(
        "websockets is not installed: run pip install 'rlrobot-edu[ros]'; everything else works without it"
    ) from None

OPEN_TIMEOUT = 5.0  # for somebody to answer [s]
CLOSE_TIMEOUT = 1.0  # for the other side to say goodbye, too [s]
SEND_TIMEOUT = 2  # for the other side to take anything of what is sent, once all buffers are full [s]
PING_INTERVAL, PING_TIMEOUT = (
    5.0,
    10.0,
)  # a dead network is noticed within the sum of them [s]
LARGEST_MESSAGE = 2**24  # [bytes]
COMPLAINTS = 5  # so many are kept
ENDED = "is lost; see whether rosbridge and the network are up, then connect again"

log = logging.getLogger(__name__)
log.addHandler(
    logging.NullHandler()
)  # what is the matter is said in `lost`, not on the screen
OPTIONS: dict[str, Any] = {  # compression takes longer than it saves in a local network
    "proxy": None, "compression": None, "open_timeout": OPEN_TIMEOUT, "ping_interval": PING_INTERVAL,
    "ping_timeout": PING_TIMEOUT, "close_timeout": CLOSE_TIMEOUT, "max_size": LARGEST_MESSAGE, "logger": log,
}  # fmt: skip
ADDRESS = re.compile(r"wss?://(\[[\da-fA-F:.]+\]|[^\s/?#@:\[\]]+):(\d{1,5})(/[^\s#]*)?")


class Rosbridge:
    """A connection to rosbridge. It does not come back by itself after it was lost: make a new one.

    address: of rosbridge, such as "ws://192.168.0.10:9090"
    lost: why nothing comes or goes any more, in words; None while all is well
    unreadable: how many messages came that cannot be understood, or that nobody asked for
    complaints: the latest errors that rosbridge told of, or that arose in hearing a message

    A dead network is noticed within 15 s, since rosbridge is asked every 5 s for a sign of life.

    Raises ValueError for an address that is none, ConnectionError if no rosbridge answers there within 5 s.
    """

    def __init__(self, address: str = "ws://127.0.0.1:9090") -> None:
        self.address, self.unreadable = address, 0
        self.lost: str | None = None
        self.complaints: deque[str] = deque(maxlen=COMPLAINTS)
        self._callbacks: dict[str, list[Callable[[Any], None]]] = {}
        parts = ADDRESS.fullmatch(address) if isinstance(address, str) else None
        if parts is None or int(parts[2]) > 65535:
            raise ValueError(
                "the address of rosbridge must be ws://, the robot's name or number, a colon and the port, as in "
                f"'ws://192.168.0.10:9090', got {address!r:.200}"
            )
        try:
            # the way to open a connection for longer than a block that all versions of websockets have
            self._socket = ExitStack().enter_context(connect(address, **OPTIONS))
        except (
            OSError,
            EOFError,
            ValueError,
            WebSocketException,
        ) as error:  # ValueError: a name that cannot be
            raise ConnectionError(
                f"no rosbridge answers at {address} ({describe_error(error)}); is it running on the robot? "
                "Start it with "
                "roslaunch rosbridge_server rosbridge_websocket.launch (ROS 1) or "
                "ros2 launch rosbridge_server rosbridge_websocket_launch.xml (ROS 2)"
            ) from None
        # a sender does not wait for ever for a robot that takes nothing any more
        form, timeout = (
            ("I", [SEND_TIMEOUT * 1000])
            if sys.platform == "win32"
            else ("ll", [SEND_TIMEOUT, 0])
        )
        self._socket.socket.setsockopt(
            socket.SOL_SOCKET, socket.SO_SNDTIMEO, struct.pack(form, *timeout)
        )
        self._thread = threading.Thread(
            target=self._listen, name=f"rosbridge {address}", daemon=True
        )
        self._thread.start()

    def make(self, kind: str, **fields: Any) -> dict[str, Any]:
        """A message, or a part of one: its fields as a dictionary.

        A time has the names that ROS 2 gives it, which rosbridge of ROS 1 does not know. A TwistStamped, which goes to
        real robots, therefore has no time: both rosbridges then put in the robot's own, and that is better anyway,
        since many robots take a command for outdated whose sender's clock is late. Odometry and LaserScan keep their
        times, which give their age; only a served robot sends them, to our own router.
        """
        if kind == TWIST_STAMPED:
            fields["header"] = {
                name: value
                for name, value in fields["header"].items()
                if name != "stamp"
            }
        return fields

    def hear(self, topic: str, kind: str, callback: Callable[[Any], None]) -> None:
        """From now on call `callback` with each message of this topic, in the connection's own thread."""
        self._callbacks.setdefault(topic, []).append(callback)
        self._send(
            op="subscribe", topic=topic, type=kind, queue_length=1, throttle_rate=0
        )

    def speak(self, topic: str, kind: str) -> Callable[[Any], None]:
        """A function that sends a message to this topic. It raises ConnectionError if the connection is lost."""
        self._send(op="advertise", topic=topic, type=kind)
        return lambda message: self._send(op="publish", topic=topic, msg=message)

    def close(self) -> None:
        """End it within about 2 s; what was sent before still goes out. Nothing is heard after that."""
        self._lose("was closed here")
        self._socket.close()
        if threading.current_thread() is not self._thread:
            self._thread.join(CLOSE_TIMEOUT)

    def _send(self, **said: Any) -> None:
        if self.lost is None:
            try:
                self._socket.send(to_json(said))
                return
            except ConnectionClosed as error:
                self._lose(f"{ENDED} ({error})")
        raise ConnectionError(self.lost)

    def _lose(self, why: str) -> None:
        if self.lost is None:
            self.lost = f"the connection to rosbridge at {self.address} {why}"

    def _listen(self) -> None:
        """Hear until the end, in a thread of its own."""
        try:
            while self.lost is None:
                text = self._socket.recv(
                    decode=False
                )  # bytes: what is no UTF-8 shall not end the connection
                if self.lost is None:
                    self._understand(text)
        except ConnectionClosed as error:
            self._lose(f"{ENDED} ({error})")

    def _understand(self, text: bytes) -> None:
        """Do what the other side says. It never raises, whatever the message is."""
        try:
            said = vars(
                json.loads(text, object_hook=lambda fields: SimpleNamespace(**fields))
            )
            if said["op"] == "status":
                if said.get("level") == "error":
                    self.complaints.append(f"{said.get('msg')!s:.500}")
                return
            callbacks, message = self._callbacks[said["topic"]], said["msg"]
            if said["op"] != "publish" or not isinstance(message, SimpleNamespace):
                raise ValueError
        except (
            ValueError,
            TypeError,
            KeyError,
            RecursionError,
        ):  # no JSON, no object, no topic, too deep
            self.unreadable += 1
            return
        for callback in list(callbacks):
            try:
                callback(message)
            except Exception as error:  # the next message may be better
                self.complaints.append(describe_error(error))


def to_json(value: Any) -> str:
    """`value` as strict JSON, which has no infinity and no NaN; they become null, as rosbridge does it, too."""
    text = json.dumps(value, default=float)
    if "NaN" in text or "Infinity" in text:
        text = json.dumps(json.loads(text, parse_constant=lambda word: None))
    return text
