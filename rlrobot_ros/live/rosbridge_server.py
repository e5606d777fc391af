"""A small server of rosbridge's protocol, which passes messages on between its clients.

It stands in for rosbridge and ROS on this computer, between a simulated robot and the program that drives it. It knows
subscribe, advertise and publish, and does not check types; the real one does, and has services and parameters, too.
"""

import asyncio
import contextlib
import json
import threading
from collections import defaultdict
from collections.abc import Coroutine
from typing import Any, TypeVar

# isort: split
from rlrobot_ros.live.rosbridge import (  # first: it says if websockets is missing
    CLOSE_TIMEOUT,
    OPTIONS,
)

# isort: split
from websockets.asyncio.server import Server, ServerConnection, broadcast, serve
from websockets.exceptions import ConnectionClosed

HOST = "127.0.0.1"  # every program that reaches this address may drive the robot, but no web page

T = TypeVar("T")


class RosbridgeServer(contextlib.AbstractContextManager["RosbridgeServer"]):
    """A server of rosbridge's protocol on this computer, and for this computer only.

    As rosbridge does between nodes of ROS, it passes each message on to all clients that have subscribed to its topic.
    A client that reads nothing for 15 s is disconnected, and does not delay the others. A web page is refused:
    otherwise any page in a browser on this computer could drive the robot.

    address: for clients, "ws://127.0.0.1:PORT"
    port: at which it listens; 0 picks one that is free

    Raises ValueError if the port is not one, ConnectionError if it is taken.
    """

    def __init__(self, port: int = 9090) -> None:
        if not (isinstance(port, int) and 0 <= port <= 65535):
            raise ValueError(
                f"a port is a whole number from 0 to 65535, got {port!r:.200}"
            )
        self._clients: set[ServerConnection] = set()
        # by topic: who has subscribed to it, and under which name
        self._subscribers: dict[str, dict[ServerConnection, str]] = defaultdict(dict)
        # a thread and a loop of its own: in a notebook the main thread's loop is in use
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, daemon=True)
        self._thread.start()
        try:
            self._server = self._run(self._open(port))
        except OSError as error:
            self._end_loop()
            raise ConnectionError(
                f"port {port} is not free ({error.strerror}): another rosbridge may be running; end it, or choose "
                "another port, 0 for any"
            ) from None
        self.port: int = next(iter(self._server.sockets)).getsockname()[1]
        self.address = f"ws://{HOST}:{self.port}"

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """End it within about 3 s. Clients that read still get what was sent to them before."""
        if not self._loop.is_closed():
            self._run(self._end())
            self._end_loop()

    def _run(self, work: Coroutine[Any, Any, T]) -> T:
        return asyncio.run_coroutine_threadsafe(work, self._loop).result()

    def _end_loop(self) -> None:
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()

    async def _open(self, port: int) -> Server:
        # no origin: a browser would say from which web page it comes
        return await serve(self._attend, HOST, port, origins=[None], **OPTIONS)

    async def _end(self) -> None:
        self._server.close()
        closed = asyncio.create_task(self._server.wait_closed())
        await asyncio.wait([closed], timeout=2 * CLOSE_TIMEOUT)
        for client in self._clients:  # those that take nothing any more
            client.transport.abort()
        await closed

    async def _attend(self, client: ServerConnection) -> None:
        """Serve one client until it goes."""
        self._clients.add(client)
        try:
            with contextlib.suppress(ConnectionClosed):
                async for text in client:
                    self._answer(client, text)
        finally:
            self._clients.remove(client)
            for subscribers in self._subscribers.values():
                subscribers.pop(client, None)

    def _answer(self, client: ServerConnection, text: str | bytes) -> None:
        """Do what a client asks for, or say why not."""
        try:
            request = json.loads(text)
            name = request["topic"]
            topic = name.strip("/")  # the first slash may be left out
            match request["op"]:
                case "subscribe":
                    self._subscribers[topic][client] = name
                case "publish":
                    self._publish(topic, request["msg"])
                case "advertise":
                    pass
                case other:
                    raise ValueError(f"unknown op {other!r:.100}")
        except Exception as error:  # a request may be anything
            status = {
                "op": "status",
                "level": "error",
                "msg": f"{type(error).__name__}: {error}",
            }
            broadcast([client], json.dumps(status))

    def _publish(self, topic: str, message: Any) -> None:
        for client, name in self._subscribers[topic].items():
            publication = {"op": "publish", "topic": name, "msg": message}
            broadcast([client], json.dumps(publication))
