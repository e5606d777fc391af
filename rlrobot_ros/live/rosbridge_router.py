"""A small server that speaks rosbridge's protocol and passes messages on between its clients.

It stands in for rosbridge and ROS on this computer, between a simulated robot and the program that drives it. It has no
services, parameters, compression or fragments, which the real one has.
"""

import contextlib
import json
import socket
import threading
import time
from collections import deque
from concurrent.futures import ThreadPoolExecutor
from typing import Any

from rlrobot_ros.live.rosbridge import (
    LARGEST_MESSAGE,
    log,
    to_json,
)  # first: it says if websockets is missing

# isort: split
from websockets.exceptions import ConnectionClosed
from websockets.frames import CloseCode
from websockets.sync.server import ServerConnection, serve

HOST = "127.0.0.1"  # every program that reaches this address may drive the robot, but no web page
OPEN_TIMEOUT = 2.0  # in which who connects must have said what it wants [s]
CLOSE_TIMEOUT = (
    1.0  # in which clients take what still waits for them, and then say goodbye [s]
)
OPS = (
    "publish",
    "subscribe",
    "unsubscribe",
    "advertise",
    "unadvertise",
)  # a method of the router's does each
MOST_WAITING = (
    100  # messages of a topic for a client that names no queue_length, or a longer one
)

Said = dict[str, Any]


_Subscription = tuple[
    int, str, str
]  # how many messages may wait, the topic as the client writes it, and its type


class _Client:
    """A connected client: its topics, and the messages that wait for it. A thread of its own writes to it.

    advertised: types by topic; subscribed: by topic and the id of the subscription
    """

    def __init__(self, connection: ServerConnection) -> None:
        self.advertised: dict[str, str] = {}
        self.subscribed: dict[str, dict[str, _Subscription]] = {}
        self._connection = connection
        self._waiting: deque[tuple[str, str]] = deque()
        self._changed = threading.Condition()
        self._is_ending = False
        self._thread = threading.Thread(target=self._write, daemon=True)
        self._thread.start()

    def types(self, topic: str) -> list[str]:
        """The types that this client gives the topic."""
        advertised = [self.advertised[topic]] if topic in self.advertised else []
        return advertised + [
            kind for _, _, kind in self.subscribed.get(topic, {}).values()
        ]

    def tell(self, level: str, text: str, said: Any) -> None:
        """Answer with a status what the client said, and with its id if it gave one."""
        answer = {"op": "status", "level": level, "msg": text}
        if isinstance(said, dict) and isinstance(said.get("id"), str | int):
            answer["id"] = said["id"]
        self.give("", to_json(answer), MOST_WAITING)

    def give(self, topic: str, text: str, most: int) -> None:
        """Let this be written next; if `most` of the topic wait already, the oldest of them is dropped."""
        with self._changed:
            waiting = [
                i for i, (other, _) in enumerate(self._waiting) if other == topic
            ]
            if len(waiting) >= most:
                del self._waiting[waiting[0]]
            self._waiting.append((topic, text))
            self._changed.notify()

    def end(self, deadline: float) -> None:
        """Write what still waits, no longer than until then, and end the connection and the thread."""
        with self._changed:
            self._is_ending = True
            self._changed.notify()
        self._thread.join(max(0.0, deadline - time.monotonic()))
        if self._thread.is_alive():  # the client takes nothing
            with contextlib.suppress(OSError):
                self._connection.socket.shutdown(socket.SHUT_RDWR)
            self._thread.join()
        self._connection.close(CloseCode.GOING_AWAY)

    def _write(self) -> None:
        with contextlib.suppress(ConnectionClosed):
            while True:
                with self._changed:
                    self._changed.wait_for(lambda: self._waiting or self._is_ending)
                    if not self._waiting:
                        return
                    _, text = self._waiting.popleft()
                self._connection.send(text)


class RosbridgeRouter(contextlib.AbstractContextManager["RosbridgeRouter"]):
    """A server of rosbridge's protocol on this computer, and for this computer only.

    As rosbridge does between nodes of ROS, it passes each message on to all clients that have subscribed to its topic.
    A topic has one type as long as somebody advertises it or has subscribed to it. A client that publishes
    without advertising is taken to advertise, if the type is known. A client that does not read loses old messages,
    and holds up nobody. A web page is refused: with anybody's in its browser, a computer would let anybody drive.

    address: for clients, "ws://127.0.0.1:PORT"
    port: at which it listens; 0 picks one that is free

    Raises ValueError for what is no port, ConnectionError if the port is taken.
    """

    def __init__(self, port: int = 9090) -> None:
        if not (isinstance(port, int) and 0 <= port <= 65535):
            raise ValueError(
                f"a port is a whole number from 0 to 65535, got {port!r:.200}"
            )
        self._clients: list[_Client] = []
        self._lock = threading.Lock()
        try:
            # of all origins only none at all: a browser says from which web page it comes
            self._server = serve(
                self._attend, HOST, port, origins=[None], compression=None, open_timeout=OPEN_TIMEOUT,
                close_timeout=CLOSE_TIMEOUT, max_size=LARGEST_MESSAGE, logger=log,
            )  # fmt: skip
        except OSError as error:
            raise ConnectionError(
                f"port {port} is not free ({error.strerror}): another router or rosbridge may be running; end it, or "
                "choose another port, 0 for any"
            ) from None
        self.port: int = self._server.socket.getsockname()[1]
        self.address = f"ws://{HOST}:{self.port}"
        self._thread = threading.Thread(
            target=self._server.serve_forever, name=f"router {self.port}", daemon=True
        )
        self._thread.start()

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """End it within about 3 s. Clients that read still get what was sent to them before."""
        deadline = time.monotonic() + CLOSE_TIMEOUT
        with self._lock:
            clients = list(self._clients)
        with ThreadPoolExecutor(
            max_workers=len(clients) + 1
        ) as each:  # who takes nothing holds up nobody
            each.map(lambda client: client.end(deadline), clients)
        self._server.shutdown()
        self._thread.join()

    def _attend(self, connection: ServerConnection) -> None:
        """Listen to one client until it goes, in a thread of its own."""
        client = _Client(connection)
        with self._lock:
            self._clients.append(client)
        try:
            with contextlib.suppress(ConnectionClosed):
                while True:
                    self._obey(client, connection.recv(decode=False))
        finally:
            with self._lock:
                self._clients.remove(client)
            client.end(time.monotonic())

    def _obey(self, client: _Client, text: bytes) -> None:
        """Do what a client says, or answer why not."""
        said: Any = None
        try:
            said = json.loads(text)
            if not (isinstance(said, dict) and isinstance(said.get("op"), str)):
                raise ValueError("a message must be an object of JSON with an op")
            if said["op"] not in OPS:
                raise ValueError(
                    f"unknown op {said['op']!r:.100}; there are {', '.join(OPS)}"
                )
            if not (isinstance(said.get("topic"), str) and said["topic"].strip("/")):
                raise ValueError(f"{said['op']} needs a topic")
            with self._lock:
                getattr(self, f"_{said['op']}")(client, said)
        except (ValueError, RecursionError) as error:
            client.tell("error", str(error), said)

    def _advertise(self, client: _Client, said: Said) -> None:
        client.advertised[_topic(said)] = self._type(said)

    def _unadvertise(self, client: _Client, said: Said) -> None:
        if client.advertised.pop(_topic(said), None) is None:
            client.tell(
                "warning", f"{said['topic']} was not advertised by this client", said
            )

    def _subscribe(self, client: _Client, said: Said) -> None:
        kind, length = self._type(said), said.get("queue_length", 0)
        if not (isinstance(length, int) and length >= 0):
            raise ValueError(
                f"queue_length must be a whole number of at least 0, got {length!r:.100}"
            )
        subscriptions = client.subscribed.setdefault(_topic(said), {})
        subscriptions[str(said.get("id"))] = (
            min(length or MOST_WAITING, MOST_WAITING),
            said["topic"],
            kind,
        )

    def _unsubscribe(self, client: _Client, said: Said) -> None:
        subscriptions = client.subscribed.get(_topic(said), {})
        subscriptions.pop(str(said.get("id")), None)
        if not subscriptions or said.get("id") is None:  # without an id all are meant
            client.subscribed.pop(_topic(said), None)

    def _publish(self, client: _Client, said: Said) -> None:
        topic, message = _topic(said), said.get("msg")
        if not isinstance(message, dict):
            raise ValueError(f"publish to {topic} needs a msg, an object of JSON")
        if topic not in client.advertised:
            self._advertise(client, said)
        texts: dict[str, str] = {}  # JSON of a scan takes longer than all else
        for listener in self._clients:
            if topic in listener.subscribed:
                queue_length, name, _ = min(listener.subscribed[topic].values())
                if name not in texts:
                    texts[name] = to_json(
                        {"op": "publish", "topic": name, "msg": message}
                    )
                listener.give(topic, texts[name], queue_length)

    def _type(self, said: Said) -> str:
        """The type of a topic. Raises ValueError if it is unknown, or known to be another."""
        topic, kind = _topic(said), said.get("type")
        known = next(
            (kind for client in self._clients for kind in client.types(topic)), None
        )
        if kind is None and known is not None:
            return known
        if not (isinstance(kind, str) and kind):
            raise ValueError(
                f"the type of {topic} is unknown: nobody advertises it, and {said['op']} names none"
            )
        kind = kind.replace("/msg/", "/")
        if known not in (None, kind):
            raise ValueError(f"{topic} is of type {known}, not {kind}")
        return kind


def _topic(said: Said) -> str:
    """The topic's whole name; nodes of ROS, too, may leave out the first slash."""
    return f"/{said['topic'].strip('/')}"
