"""A way to a robot over ROS 1: the node that rospy makes of this process."""

import http.client
import importlib
import logging
import os
import threading
import time
import xmlrpc.client
from collections.abc import Callable
from contextlib import suppress
from typing import Any
from urllib.parse import urlsplit

from rlrobot_edu.task.messages import in_words

PATIENCE = 3.0  # how long a master may take to answer, and what was sent to go out [s]
WAIT = 0.002  # between two looks at what goes out [s]
CLOSED = "this connection was closed"
ENDED = (
    "the ROS node of this process was shut down from outside, and rospy cannot start another one: "
    "start Python anew (in a notebook: restart the kernel)"
)


class RospyNode:
    """A `Connection` through rospy, for robots of ROS 1.

    master: URI of the ROS master; None takes the environment's ROS_MASTER_URI, or else http://localhost:11311/

    rospy allows a process one node, once. So all connections of a process share it, with one master. `close` ends what
    this connection hears and sends; the node itself stays, without topics of ours, until the process ends: rospy's
    threads, its listening sockets, and its name at the master.

    A master on 127.0.0.1 means that all is on this machine: then rospy listens on 127.0.0.1 only, unless ROS_IP or
    ROS_HOSTNAME says otherwise. If the robot's nodes run on another machine, set ROS_IP to the address at which this
    one is reached from there; rospy then listens on all its addresses. Both ROS_MASTER_URI and ROS_IP are set for the
    whole process, since there rospy looks them up.

    A robot's node that dies and comes back is heard again. Messages sent before it listens are lost, as always in
    ROS 1. The master may go away while messages flow; a new one does not know of this node.

    rospy writes no log files here; its warnings go to stderr and /rosout. What it changes in the process nevertheless:
    new sockets get a timeout of 60 s unless they ask for another one, and XML-RPC refuses entities in XML (defusedxml).

    Raises ImportError if rospy is missing, ConnectionError if there is no master or the node cannot be had.
    """

    complaints = ()  # nobody says any

    def __init__(self, master: str | None = None) -> None:
        self.lost: str | None = None
        self._rospy = rospy = _load_rospy()
        self._lock = threading.Lock()  # nothing is sent while the connection is being closed
        self._topics: list[Any] = []
        network, rosgraph = (importlib.import_module(name) for name in ("rosgraph.network", "rosgraph"))
        current = rosgraph.get_master_uri()
        self._master = master or current
        if rospy.is_shutdown():
            raise ConnectionError(ENDED)
        if rospy.core.is_initialized() and self._master.rstrip("/") != current.rstrip("/"):
            raise ConnectionError(
                f"this process has a ROS node at the master {current}, and rospy allows it no second one at "
                f"{self._master:.200}: start Python anew (in a notebook: restart the kernel)"
            )
        _ask(self._master)  # rospy itself would wait for it for ever
        if not rospy.core.is_initialized():
            os.environ["ROS_MASTER_URI"] = self._master
            if _is_this_machine(self._master) and not network.get_address_override():
                os.environ["ROS_IP"] = "127.0.0.1"
            _start_node(rospy)
        rospy.on_shutdown(self._end)

    def make(self, kind: str, **fields: Any) -> Any:
        """A message, or a part of one, of this kind with these fields (see messages.py).

        Raises ImportError if this kind of message is not installed, AttributeError for a field that it has not.
        """
        if kind == "builtin_interfaces/Time":  # ROS 2's; in ROS 1 a time is no message, and its fields are secs, nsecs
            return self._rospy.Time(fields["sec"], fields["nanosec"])
        return _class_of(kind)(**fields)

    def hear(self, topic: str, kind: str, callback: Callable[[Any], None]) -> None:
        """From now on call `callback` with each message of this topic, in a thread of rospy's, one after the other.

        If they come faster than it returns, it gets the latest. Raises ConnectionError if the connection is lost or the
        master is gone.
        """

        def heard(message: Any) -> None:
            if self.lost is None:
                callback(message)

        self._open(self._rospy.Subscriber, topic, kind, callback=heard, queue_size=1, tcp_nodelay=True)

    def speak(self, topic: str, kind: str) -> Callable[[Any], None]:
        """A function that sends a message to this topic and returns at once; it can be called from any thread.

        Both raise ConnectionError if the connection is lost.
        """
        publisher = self._open(self._rospy.Publisher, topic, kind, queue_size=10, tcp_nodelay=True)

        def send(message: Any) -> None:
            with self._lock:
                if self.lost is not None:
                    raise ConnectionError(self.lost)
                publisher.publish(message)

        return send

    def close(self) -> None:
        """End what is heard and sent here; what was sent before still goes out.

        A callback that is at work may come to its end after that; none begins. A master that does not answer is
        waited for a few seconds.
        """
        with self._lock:
            self._end(CLOSED)
            topics, self._topics = self._topics, []
        ending = threading.Thread(target=self._unregister, args=(topics,), daemon=True)
        ending.start()
        ending.join(2 * PATIENCE)

    def _open(self, end: Callable[..., Any], topic: str, kind: str, **how: Any) -> Any:
        if self.lost is not None:
            raise ConnectionError(self.lost)
        message = _class_of(kind)
        _ask(self._master)  # see above
        opened = end(topic, message, **how)
        self._topics.append(opened)
        return opened

    def _end(self, why: str = ENDED) -> None:
        self.lost = self.lost or why

    def _unregister(self, topics: list[Any]) -> None:
        deadline = time.monotonic() + PATIENCE
        for topic in topics:
            if isinstance(topic, self._rospy.Publisher):
                for connection in topic.impl.connections:
                    with suppress(Exception):  # it may break at any moment
                        _flush(connection, deadline)
            topic.unregister()


def _load_rospy() -> Any:
    """The module rospy. Raises ImportError if it is missing."""
    loggers = logging.getLoggerClass()
    try:
        return importlib.import_module("rospy")
    except ImportError as error:
        raise ImportError(
            f"rospy cannot be imported ({in_words(error)}): it comes with ROS 1 or, on Debian and Ubuntu, as "
            "python3-rospy, not from PyPI; without it use the link 'rosbridge'"
        ) from None
    finally:
        logging.setLoggerClass(loggers)  # with rospy's, log records of other packages would name a wrong line


def _class_of(kind: str) -> Any:
    """The class of messages of this kind. Raises ImportError if it is not installed."""
    found = importlib.import_module("genpy.message").get_message_class(kind)
    if found is None:
        package = kind.split("/")[0].replace("_", "-")
        raise ImportError(
            f"there are no ROS messages of the kind {kind!r:.200}; if it is spelled as it should be, install its "
            f"package, on Debian and Ubuntu python3-{package:.100}"
        )
    return found


def _start_node(rospy: Any) -> None:
    """Make this process a node, under a name of its own. Ctrl-C stays Python's, and so does logging."""
    configure = rospy.core.configure_logging
    rospy.core.configure_logging = lambda name: None  # it would write into ~/.ros and take the root logger for itself
    try:
        rospy.init_node("rlrobot_edu", anonymous=True, disable_signals=True, log_level=rospy.WARN)
    finally:
        rospy.core.configure_logging = configure
    logging.getLogger("rosout").addHandler(logging.StreamHandler())  # else nobody would see a callback's error


def _flush(connection: Any, deadline: float) -> None:
    """Wait until a publisher's connection has sent what is in its queue: unregistering would drop it.

    Its thread takes all that is in the queue and then sends it. So when it has taken what was added later, an empty
    piece, it has sent what was there before.
    """
    for _ in range(2):
        while connection._queue and not connection.done and time.monotonic() < deadline:
            time.sleep(WAIT)
        if connection._queue or connection.done:
            return
        connection.write_data(b"")


def _is_this_machine(uri: str) -> bool:
    host = urlsplit(uri).hostname or ""
    return host in ("localhost", "::1") or host.startswith("127.")


class _Hurried(xmlrpc.client.Transport):
    """XML-RPC that does not wait for an answer for ever."""

    def make_connection(self, host: Any) -> http.client.HTTPConnection:
        connection = super().make_connection(host)
        connection.timeout = PATIENCE
        return connection


def _ask(master: str) -> None:
    """Raises ConnectionError if no ROS master answers there."""
    try:
        with xmlrpc.client.ServerProxy(master, transport=_Hurried()) as proxy:
            proxy.getPid("/rlrobot_edu")
    except Exception as error:  # whatever else may listen there
        raise ConnectionError(
            f"no ROS master answers at {master:.200} ({in_words(error)}): start roscore there, or set ROS_MASTER_URI "
            "to where it runs, such as http://127.0.0.1:11311"
        ) from None
