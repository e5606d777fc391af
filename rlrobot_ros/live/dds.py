"""ROS 2 without ROS: its messages go over DDS, and any DDS program that knows ROS's names can speak it.

Topic ``odom`` is ``rt/odom`` in DDS, and types are named as in dds_types.py. This meets every robot whose ROS 2 speaks
DDS, as Fast DDS and Cyclone DDS do, in the same domain (ROS_DOMAIN_ID); one on Zenoh is to be reached over rosbridge.
The hashes of types that nodes of ROS 2 tell each other besides are not needed: names and bytes decide.
"""

import itertools
import os
import re
import socket
import threading
from collections.abc import Callable, Sequence
from ipaddress import IPv4Address
from typing import Any
from xml.sax.saxutils import quoteattr

try:
    from cyclonedds import core
    from cyclonedds.domain import Domain, DomainParticipant
    from cyclonedds.internal import InvalidSample, dds_infinity
    from cyclonedds.pub import DataWriter
    from cyclonedds.qos import Policy, Qos
    from cyclonedds.sub import DataReader
    from cyclonedds.topic import Topic
except ImportError:
    raise ImportError(
        "cyclonedds is not installed: run pip install 'rlrobot-edu[ros]' (there is none for Python 3.14 and for Linux "
        "on ARM); rosbridge works without it"
    ) from None

from rlrobot_edu.checks import describe_error, did_you_mean
from rlrobot_ros.live.dds_types import TYPES
from rlrobot_ros.messages import LASER_SCAN

LAST_DOMAIN = 232
# So many programs of a machine can be found without multicast. The last one's ports exist in the last domain, too.
LAST_PARTICIPANT = 60
TOPIC = re.compile(r"/?[A-Za-z_]\w*(/[A-Za-z_]\w*)*/?", re.ASCII)

_LATEST = (Policy.Durability.Volatile, Policy.History.KeepLast(10))
# A reader that asks for no more than the best effort hears everybody; most lidars offer no more than that.
HEARING = Qos(Policy.Reliability.BestEffort, *_LATEST)
_SPEAKING = (
    *_LATEST,
    Policy.DataRepresentation(use_cdrv0_representation=True),
)  # the one that ROS 2 reads
SPEAKING = Qos(Policy.Reliability.Reliable(max_blocking_time=100_000_000), *_SPEAKING)
SPEAKING_AS_LIDAR = Qos(Policy.Reliability.BestEffort, *_SPEAKING)

# Cyclone DDS has each domain once in a process; under numbers of their own any number of connections share one.
_numbers = itertools.count(1000)


class Dds:
    """A `Connection` over DDS.

    domain: number of ROS's domain, 0 to 232; None takes the environment's ROS_DOMAIN_ID, or else 0
    interface: name of the network interface (such as "wlan0") over which the robot is reached, or its IPv4 address
    peers: names or addresses of machines to look for robots on, where the network has no multicast

    With the interface as it is, messages stay on this machine. Ports are open on all interfaces even so, since Cyclone
    DDS opens them that way, but other machines are neither heard nor answered.

    Raises ValueError for a domain, an interface or a peer that there is not.
    """

    complaints = ()  # nobody says any

    def __init__(
        self,
        domain: int | None = None,
        interface: str = "127.0.0.1",
        peers: Sequence[str] = (),
    ) -> None:
        domain = _number_of(domain)
        number = next(_numbers)
        xml = _configuration(number, domain, interface, _addresses(peers))
        try:
            self._domain = Domain(
                number, xml.encode("ascii", "xmlcharrefreplace").decode()
            )
            self._participant = DomainParticipant(number)
        except core.DDSException as error:
            there = ", ".join(name for _, name in socket.if_nameindex())
            raise ValueError(
                f"the network interface {interface!r:.200} cannot be used; give the name or the IPv4 address of one of "
                f"{there} that is up"
            ) from error
        self.lost: str | None = None
        self._is_open, self._lock = True, threading.Lock()
        self._ears: list[tuple[DataReader[Any], Callable[[Any], None]]] = []
        self._mouths: list[DataWriter[Any]] = []
        self._end, self._waitset = (
            core.GuardCondition(self._participant),
            core.WaitSet(self._participant),
        )
        self._waitset.attach(self._end)
        self._thread = threading.Thread(
            target=self._run, name=f"DDS domain {domain}", daemon=True
        )
        self._thread.start()

    def make(self, kind: str, **fields: Any) -> Any:
        """A message, or a part of one, of this kind with these fields. Raises ValueError for an unknown kind."""
        return _type(kind)(**fields)

    def hear(self, topic: str, kind: str, callback: Callable[[Any], None]) -> None:
        """From now on call `callback` with each message of this topic, in the connection's thread.

        Raises ValueError for what is no topic or an unknown kind, ConnectionError after the end.
        """
        with self._lock:
            reader = DataReader(
                self._participant_now(), self._topic(topic, kind), HEARING
            )
            self._ears.append((reader, callback))
            # of any state, also that of a writer which has gone: what it said last may still be unread
            condition = core.ReadCondition(
                reader,
                core.SampleState.Any | core.ViewState.Any | core.InstanceState.Any,
            )
            self._waitset.attach(condition)

    def speak(self, topic: str, kind: str) -> Callable[[Any], None]:
        """A function that sends a message to this topic, as a lidar would if it is a scan, else reliably.

        A subscriber that joins later does not get it. Raises ValueError for what is no topic or an
        unknown kind, ConnectionError after the end; the function does so, too.
        """
        with self._lock:
            qos = SPEAKING_AS_LIDAR if kind == LASER_SCAN else SPEAKING
            self._mouths.append(
                DataWriter(self._participant_now(), self._topic(topic, kind), qos)
            )
            number = len(self._mouths) - 1

        def send(message: Any) -> None:
            with self._lock:
                self._participant_now()
                try:
                    self._mouths[number].write(message)
                except core.DDSException as error:  # who hears it takes nothing more
                    raise ConnectionError(
                        f"a message could not be sent over DDS ({describe_error(error)})"
                    ) from error

        return send

    def close(self) -> None:
        """End it; nothing is heard after that. It may be called again, and in a callback."""
        with self._lock:
            if self._is_open:
                self._is_open = False
                self._end.set(True)
        if threading.current_thread() is not self._thread:
            self._thread.join()

    def _participant_now(self) -> DomainParticipant:
        """The participant. Raises ConnectionError after the end."""
        if not self._is_open:
            raise ConnectionError(self.lost or "this connection is closed")
        return self._participant

    def _topic(self, topic: str, kind: str) -> Topic[Any]:
        """The topic of DDS that is ROS's topic of this name."""
        if not TOPIC.fullmatch(topic):
            raise ValueError(
                f"a topic is named as in 'odom' or '/robot1/odom', got {topic!r:.200}"
            )
        return Topic(self._participant, f"rt/{topic.strip('/')}", _type(kind))

    def _run(self) -> None:
        """The connection's thread: it calls back until the end, then frees everything."""
        try:
            self._call_back()
        except Exception as error:  # whatever a callback raised
            self.lost = f"a message could not be dealt with ({describe_error(error)})"
        with self._lock:
            self._is_open = False
            self._ears.clear()
            self._mouths.clear()
            del self._waitset, self._end, self._participant, self._domain

    def _call_back(self) -> None:
        """Hand over what comes, a message of each topic at a time, until the end."""
        while self._is_open:
            self._waitset.wait(dds_infinity)
            for reader, callback in self._ears.copy():
                for message in _taken(reader):
                    if not self._is_open:
                        return
                    callback(message)


def _taken(reader: DataReader[Any]) -> list[Any]:
    """The next message, if there is one. That a writer has gone is none, nor is one whose text is no UTF-8."""
    try:
        return [
            message
            for message in reader.take()
            if not isinstance(message, InvalidSample)
        ]
    except UnicodeDecodeError:
        return []


def _number_of(domain: int | None) -> int:
    """The domain's number; that of the environment if none is given."""
    name, given = "domain", domain
    if domain is None:
        name, said = "ROS_DOMAIN_ID", os.environ.get("ROS_DOMAIN_ID") or "0"
        given = int(said) if said.isdecimal() else None
    if not isinstance(given, int) or not 0 <= given <= LAST_DOMAIN:
        got = repr(domain) if domain is not None else os.environ["ROS_DOMAIN_ID"]
        raise ValueError(
            f"{name} must be a whole number from 0 to {LAST_DOMAIN}, got {got:.200}"
        )
    return given


def _type(kind: str) -> type[Any]:
    if kind not in TYPES:
        raise ValueError(
            f"there is no kind of message {kind!r:.200}; {did_you_mean(kind, TYPES)}there are {', '.join(TYPES)}"
        )
    return TYPES[kind]


def _addresses(peers: Sequence[str]) -> list[str]:
    """The IPv4 addresses of these machines."""
    if isinstance(peers, str):
        raise ValueError(
            f"peers must be a list of names or addresses, as in [{peers!r:.200}]"
        )
    addresses = []
    for peer in peers:
        try:
            addresses.append(str(IPv4Address(socket.gethostbyname(peer or "?"))))
        except (OSError, UnicodeError, TypeError) as error:
            raise ValueError(
                f"no computer is called {peer!r:.200}; give the robot's name or IPv4 address"
            ) from error
    return addresses


def _configuration(number: int, domain: int, interface: str, peers: list[str]) -> str:
    """The settings of Cyclone DDS. It knows the domain of ROS as `number`, and by its own number on the network."""
    try:
        by, is_here = "address", IPv4Address(str(interface)).is_loopback
    except ValueError:
        by, is_here = "name", False
    if is_here:
        if away := [peer for peer in peers if not IPv4Address(peer).is_loopback]:
            raise ValueError(
                f"{away[0]} is not reached over {interface}; name the interface as well, such as 'wlan0'"
            )
        peers = [*peers, "127.0.0.1"]
    addresses = "".join(f'<Peer address="{peer}"/>' for peer in peers)
    return f"""<CycloneDDS><Domain Id="{number}">
        <General><Interfaces><NetworkInterface {by}={quoteattr(str(interface))}/></Interfaces>
            <AllowMulticast>{"false" if is_here else "default"}</AllowMulticast></General>
        <Discovery><ExternalDomainId>{domain}</ExternalDomainId><ParticipantIndex>auto</ParticipantIndex>
            <MaxAutoParticipantIndex>{LAST_PARTICIPANT}</MaxAutoParticipantIndex><Peers>{addresses}</Peers></Discovery>
    </Domain></CycloneDDS>"""
