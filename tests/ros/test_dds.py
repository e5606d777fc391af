"""ROS 2 over DDS: the names, bytes and manners of ROS 2, between threads, processes and foreign programs."""

import atexit
import importlib
import math
import subprocess
import sys
import threading
import time
from contextlib import closing, contextmanager, nullcontext

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ros2 import claimed
from waiting import eventually

from rlrobot_ros.live.connection import connect
from rlrobot_ros.messages import (
    LASER_SCAN,
    ODOMETRY,
    TWIST,
    TWIST_STAMPED,
    make_laser_scan,
    make_odometry,
    make_twist,
    make_twist_stamped,
    pose_of,
    velocity_of,
)

pytest.importorskip(
    "cyclonedds", reason="cyclonedds is missing: pip install 'rlrobot-edu[ros]'"
)
from cyclonedds._clayer import ddspy_write
from cyclonedds.builtin import (
    BuiltinDataReader,
    BuiltinTopicDcpsPublication,
    BuiltinTopicDcpsSubscription,
)
from cyclonedds.domain import Domain, DomainParticipant
from cyclonedds.pub import DataWriter
from cyclonedds.qos import Policy, Qos
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic

from rlrobot_ros.live.dds import Dds
from rlrobot_ros.live.dds_types import TYPES

DOMAIN, CLAIM = claimed()
atexit.register(CLAIM.close)
SILENT_DOMAIN = 101
PATIENCE = 60.0  # [s], on a busy machine; all takes some milliseconds otherwise
RELIABLE, BEST_EFFORT = (
    Qos(Policy.Reliability.Reliable(10**8)),
    Qos(Policy.Reliability.BestEffort),
)


@contextmanager
def opened(*domains, **where):
    """A connection for each of these domains."""
    connections = [Dds(domain, **where) for domain in domains]
    try:
        yield connections
    finally:
        for connection in connections:
            connection.close()


@pytest.fixture
def two():
    """Two connections that can hear each other."""
    with opened(DOMAIN, DOMAIN) as connections:
        yield connections


def stranger(address="127.0.0.1", number=5000):
    """A participant of DDS that knows nothing of our library; keep both that are returned."""
    xml = f"""<CycloneDDS><Domain Id="{number}">
        <General><Interfaces><NetworkInterface address="{address}"/></Interfaces>
            <AllowMulticast>false</AllowMulticast></General>
        <Discovery><ExternalDomainId>{DOMAIN}</ExternalDomainId><ParticipantIndex>auto</ParticipantIndex>
            <Peers><Peer address="{address}"/></Peers></Discovery></Domain></CycloneDDS>"""
    return Domain(number, xml), DomainParticipant(number)


# Bytes


@pytest.fixture(scope="module")
def store():
    typesys = pytest.importorskip(
        "rosbags.typesys", reason="rosbags is missing: pip install 'rlrobot-edu[ros]'"
    )
    return typesys.get_typestore(typesys.Stores.ROS2_JAZZY)


def long_name(kind):
    return kind.replace("/", "/msg/")


NUMBERS = {
    "float32": st.floats(width=32, allow_nan=False) | st.just(math.nan),
    "float64": st.floats(allow_nan=False) | st.just(math.nan),
    "int32": st.integers(-(2**31), 2**31 - 1),
    "uint32": st.integers(0, 2**32 - 1),
    "string": st.text(st.characters(codec="utf-8", exclude_characters="\0")),
}


def contents(store, kind):
    """Any content of this kind of message, by the definitions that rosbags has: a dict of numbers, lists and dicts."""
    fields = {}
    for name, (node, of) in store.fielddefs[long_name(kind)][1]:
        node = node.name
        if node == "NAME":
            fields[name] = contents(store, of.replace("/msg/", "/"))
            continue
        basic = NUMBERS[of[0] if node == "BASE" else of[0][1][0]]
        if node == "ARRAY":
            basic = st.lists(basic, min_size=of[1], max_size=of[1])
        elif node == "SEQUENCE":
            basic = st.lists(basic, max_size=50)
        fields[name] = basic
    return st.fixed_dictionaries(fields)


def built(make, store, kind, content, numbers=list):
    """A message with this content; numbers: what lists are made to be."""
    parts = {}
    for name, (_node, of) in store.fielddefs[long_name(kind)][1]:
        part = content[name]
        if isinstance(part, dict):
            part = built(make, store, of.replace("/msg/", "/"), part, numbers)
        elif isinstance(part, list):
            part = (
                numbers(part, np.float32 if of[0][1][0] == "float32" else np.float64)
                if numbers is not list
                else part
            )
        parts[name] = part
    return make(kind, **parts)


def ours(kind, **fields):
    return TYPES[kind](**fields)


@pytest.mark.parametrize("kind", [TWIST, TWIST_STAMPED, ODOMETRY, LASER_SCAN])
def test_the_bytes_are_those_of_ros_both_ways(store, kind):
    @settings(deadline=None, max_examples=60)
    @given(contents(store, kind))
    def check(content):
        theirs = built(
            lambda kind, **f: store.types[long_name(kind)](**f),
            store,
            kind,
            content,
            np.array,
        )
        raw = bytes(store.serialize_cdr(theirs, long_name(kind)))
        message = built(ours, store, kind, content)
        assert message.serialize() == raw
        assert repr(TYPES[kind].deserialize(raw)) == repr(
            message
        )  # in which NaN is like NaN

    check()


def test_a_long_scan_with_rays_that_met_nothing_has_the_bytes_of_ros(store):
    ranges = [0.5, math.inf, -math.inf, math.nan] * 5000
    scan = make_laser_scan(ours, 12.25, ranges, 10.0)
    theirs = store.deserialize_cdr(scan.serialize(), long_name(LASER_SCAN))
    np.testing.assert_array_equal(theirs.ranges, np.array(ranges, np.float32))
    assert bytes(store.serialize_cdr(theirs, long_name(LASER_SCAN))) == scan.serialize()


# Names and quality of service


def test_topics_and_types_are_named_as_ros_names_them(two):
    spoken = {"cmd_vel": TWIST, "/robot1/odom": ODOMETRY, "robot1/scan/": LASER_SCAN}
    for topic, kind in spoken.items():
        two[0].speak(topic, kind)
    two[0].hear("/cmd_vel_stamped", TWIST_STAMPED, print)
    _domain, participant = stranger()
    readers = [
        BuiltinDataReader(participant, topic)
        for topic in (BuiltinTopicDcpsPublication, BuiltinTopicDcpsSubscription)
    ]
    there = {
        ("rt/cmd_vel", "geometry_msgs::msg::dds_::Twist_"),
        ("rt/robot1/odom", "nav_msgs::msg::dds_::Odometry_"),
        ("rt/robot1/scan", "sensor_msgs::msg::dds_::LaserScan_"),
        ("rt/cmd_vel_stamped", "geometry_msgs::msg::dds_::TwistStamped_"),
    }
    eventually(
        lambda: (
            {
                (it.topic_name, it.type_name)
                for reader in readers
                for it in reader.read(100)
            }
            >= there
        )
    )
    names = {
        f"{kind.split('/')[0]}::msg::dds_::{kind.split('/')[1]}_" for kind in TYPES
    }
    assert {kind.__idl__.idl_transformed_typename for kind in TYPES.values()} == names


def test_a_scan_is_sent_with_best_effort_and_a_twist_reliably(two):
    sends = two[0].speak("scan", LASER_SCAN), two[0].speak("cmd_vel", TWIST)
    messages = (
        make_laser_scan(two[0].make, 0.0, [1.0], 10.0),
        make_twist(two[0].make, 1.0, 0.0),
    )
    _domain, participant = stranger()
    topics = [
        Topic(participant, f"rt/{name}", TYPES[kind])
        for name, kind in (("scan", LASER_SCAN), ("cmd_vel", TWIST))
    ]
    demanding, easy = (
        [DataReader(participant, topic, qos) for topic in topics]
        for qos in (RELIABLE, BEST_EFFORT)
    )
    heard = [0, 0, 0]

    def speak():
        for send, message in zip(sends, messages, strict=True):
            send(message)
        for i, reader in enumerate((*easy, demanding[1])):
            heard[i] += len(reader.take(100))

    eventually(lambda: min(heard) >= 20, speak)
    assert not demanding[0].get_matched_publications() and not demanding[0].take(100)


@pytest.mark.parametrize("qos", [RELIABLE, BEST_EFFORT])
def test_lidars_of_both_manners_are_heard(two, qos):
    heard = []
    two[0].hear("scan", LASER_SCAN, heard.append)
    _domain, participant = stranger()
    writer = DataWriter(
        participant, Topic(participant, "rt/scan", TYPES[LASER_SCAN]), qos
    )
    eventually(
        lambda: heard,
        lambda: writer.write(make_laser_scan(ours, 3.0, [1.0, 2.0, math.inf], 10.0)),
    )
    assert (
        list(heard[0].ranges) == [1.0, 2.0, math.inf] and heard[0].header.stamp.sec == 3
    )


def test_what_is_heard_becomes_readings(two):
    from rlrobot_edu.robots.chassis import CHASSIS
    from rlrobot_ros.scan import Mounting, laser_readings

    heard, ranges = [], [1.0 + i / 128 for i in range(360)]
    two[1].hear("scan", LASER_SCAN, heard.append)
    send, scan = (
        two[0].speak("scan", LASER_SCAN),
        make_laser_scan(two[0].make, 0.0, ranges, 10.0),
    )
    eventually(lambda: heard, lambda: send(scan))
    seen, meant = (
        laser_readings(message, CHASSIS["giraff"], Mounting())
        for message in (heard[0], scan)
    )
    assert len(seen) == 8 and seen == pytest.approx(meant, abs=1e-6)


# Life and death


ROBOT = """
import sys
from rlrobot_ros.live.dds import Dds
from rlrobot_ros.messages import *

robot = Dds(int(sys.argv[1]))
odom, scan = robot.speak("odom", ODOMETRY), robot.speak("scan", LASER_SCAN)

def obey(twist):
    v, _, omega = velocity_of(twist)
    odom(make_odometry(robot.make, 1.0, v, omega, 0.5))
    scan(make_laser_scan(robot.make, 1.0, [v] * 360, 10.0))
    print(v, omega, flush=True)

robot.hear("cmd_vel", TWIST, obey)
sys.stdin.read()
robot.close()
"""


def test_two_processes_talk_both_ways():
    with subprocess.Popen(
        [sys.executable, "-c", ROBOT, str(DOMAIN)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    ) as robot:
        try:
            with closing(connect("dds", domain=DOMAIN)) as connection:
                poses, scans = [], []
                connection.hear(
                    "/odom", ODOMETRY, lambda message: poses.append(pose_of(message))
                )
                connection.hear(
                    "/scan", LASER_SCAN, lambda message: scans.append(message.ranges)
                )
                send = connection.speak("/cmd_vel", TWIST)
                eventually(
                    lambda: poses and scans,
                    lambda: send(make_twist(connection.make, 0.25, -1.5)),
                )
            assert (
                poses[0] == pytest.approx((0.25, -1.5, 0.5))
                and list(scans[0]) == [0.25] * 360
            )
            told, _ = robot.communicate("", PATIENCE)
            assert set(told.splitlines()) == {"0.25 -1.5"}
        finally:
            robot.kill()
    assert robot.returncode == 0


def test_domains_do_not_hear_each_other():
    with opened(DOMAIN, DOMAIN, SILENT_DOMAIN) as (speaker, friend, other):
        heard, overheard = [], []
        friend.hear("cmd_vel", TWIST, heard.append)
        other.hear("cmd_vel", TWIST, overheard.append)
        send = speaker.speak("cmd_vel", TWIST)
        eventually(
            lambda: len(heard) > 20, lambda: send(make_twist(speaker.make, 1.0, 0.0))
        )
        assert not overheard


def test_the_last_domain_works():
    with opened(232, 232) as (one, two):
        heard = []
        one.hear("cmd_vel", TWIST, heard.append)
        send = two.speak("cmd_vel", TWIST)
        eventually(lambda: heard, lambda: send(make_twist(two.make, 1.0, 0.0)))


def test_what_was_said_last_arrives_although_the_speaker_closes_at_once():
    for _ in range(5):
        with opened(DOMAIN, DOMAIN) as (one, two):
            heard = []
            one.hear(
                "cmd_vel",
                TWIST,
                lambda message, heard=heard: heard.append(velocity_of(message)[0]),
            )
            send = two.speak("cmd_vel", TWIST)
            eventually(
                lambda heard=heard: heard,
                lambda send=send, two=two: send(make_twist(two.make, 1.0, 0.0)),
            )
            send(make_twist(two.make, 0.0, 0.0))
            two.close()
            eventually(lambda heard=heard: heard[-1] == 0.0)
            assert (
                set(heard) == {0.0, 1.0} and one.lost is None
            )  # that the speaker is gone, is no message


def sockets():
    psutil = pytest.importorskip("psutil")
    return {
        (it.laddr.ip, it.laddr.port) for it in psutil.Process().net_connections("inet")
    }


def test_messages_leave_from_here_to_here_alone_and_nothing_is_left_after_the_end():
    before, threads = sockets(), set(threading.enumerate())
    with opened(DOMAIN, DOMAIN) as (one, two):
        heard = []
        one.hear("cmd_vel", TWIST, heard.append)
        send = two.speak("cmd_vel", TWIST)
        eventually(lambda: heard, lambda: send(make_twist(two.make, 1.0, 0.0)))
        # Cyclone DDS receives at ports that are open everywhere; what it sends comes out of others
        first = 7400 + 250 * DOMAIN
        senders = {
            (ip, port)
            for ip, port in sockets() - before
            if not first <= port < first + 250
        }
        assert len(senders) >= 2 and {ip for ip, _ in senders} == {"127.0.0.1"}
        began = time.monotonic()
        one.close()
        two.close()
        one.close()
        assert time.monotonic() - began < 10
    assert sockets() <= before and set(threading.enumerate()) <= threads


def test_who_is_on_another_interface_neither_hears_nor_is_heard(two):
    psutil = pytest.importorskip("psutil")
    up = {name for name, it in psutil.net_if_stats().items() if it.isup}
    addresses = [
        it.address
        for name in up
        for it in psutil.net_if_addrs()[name]
        if it.family.name == "AF_INET"
    ]
    away = next(
        (address for address in addresses if not address.startswith("127.")), None
    )
    if away is None:
        pytest.skip("this machine has no other interface")
    (_domain, here), (_other, there) = stranger(), stranger(away, 5001)
    topics = [
        Topic(participant, "rt/cmd_vel", TYPES[TWIST]) for participant in (here, there)
    ]
    heard, send = [], two[0].speak("cmd_vel", TWIST)
    two[1].hear("cmd_vel", TWIST, lambda message: heard.append(velocity_of(message)[0]))
    readers = [DataReader(topic.participant, topic, BEST_EFFORT) for topic in topics]
    writers = [DataWriter(topic.participant, topic, BEST_EFFORT) for topic in topics]

    def speak():
        send(make_twist(two[0].make, 1.0, 0.0))
        for writer, v in zip(writers, (2.0, 3.0), strict=True):
            writer.write(make_twist(ours, v, 0.0))

    eventually(
        lambda: {1.0, 2.0} <= set(heard) and len(heard) > 50 and readers[0].read(),
        speak,
    )
    assert 3.0 not in heard
    assert {velocity_of(message)[0] for message in readers[1].take(1000)} <= {3.0}


def test_after_the_end_nothing_is_heard_and_speaking_says_so(two):
    heard = []
    two[0].hear("cmd_vel", TWIST, heard.append)
    send, answer = two[1].speak("cmd_vel", TWIST), two[0].speak("odom", ODOMETRY)
    eventually(lambda: heard, lambda: send(make_twist(two[1].make, 1.0, 0.0)))
    two[0].close()
    count = len(heard)
    for _ in range(20):
        send(make_twist(two[1].make, 1.0, 0.0))
    for action in (
        lambda: answer(make_odometry(two[0].make, 0.0, 0.0, 0.0, 0.0)),
        lambda: two[0].speak("cmd_vel", TWIST),
        lambda: two[0].hear("cmd_vel", TWIST, heard.append),
    ):
        with pytest.raises(ConnectionError, match="this connection is closed"):
            action()
    assert len(heard) == count and two[0].lost is None


def test_a_callback_may_close_the_connection(two):
    heard = []

    def end(message):
        heard.append(message)
        two[0].close()

    two[0].hear("cmd_vel", TWIST, end)
    send = two[1].speak("cmd_vel", TWIST)
    eventually(lambda: heard, lambda: send(make_twist(two[1].make, 1.0, 0.0)))
    for _ in range(20):
        send(make_twist(two[1].make, 1.0, 0.0))
    two[0].close()
    assert len(heard) == 1


def test_a_callback_that_raises_loses_the_connection_which_says_why(two):
    two[0].hear("cmd_vel", TWIST, lambda message: {}["wheels"])
    answer, send = two[0].speak("odom", ODOMETRY), two[1].speak("cmd_vel", TWIST)
    lost = eventually(
        lambda: two[0].lost, lambda: send(make_twist(two[1].make, 1.0, 0.0))
    )
    assert lost == "a message could not be dealt with (KeyError: 'wheels')"
    two[0].close()
    with pytest.raises(ConnectionError, match="KeyError: 'wheels'"):
        answer(make_odometry(two[0].make, 0.0, 0.0, 0.0, 0.0))


def test_a_message_whose_text_is_no_text_is_skipped(two):
    heard = []
    two[0].hear("cmd_vel", TWIST_STAMPED, heard.append)
    _domain, participant = stranger()
    writer = DataWriter(
        participant, Topic(participant, "rt/cmd_vel", TYPES[TWIST_STAMPED]), RELIABLE
    )
    good = make_twist_stamped(ours, 0.0, 1.0, 0.0)
    eventually(lambda: heard, lambda: writer.write(good))
    raw = good.serialize().replace(b"base_link", b"\xff\xfe\xfd\xfc_link")
    assert ddspy_write(writer._ref, raw.ljust(-(-len(raw) // 4) * 4, b"\0")) >= 0
    writer.write(make_twist_stamped(ours, 0.0, 2.0, 0.0))
    eventually(lambda: velocity_of(heard[-1])[0] == 2.0)
    assert two[0].lost is None and {message.header.frame_id for message in heard} == {
        "base_link"
    }


def test_who_forgets_to_close_can_leave_all_the_same():
    forgetful = f"from rlrobot_ros.live.dds import Dds; Dds({DOMAIN}).hear('odom', 'nav_msgs/Odometry', print)"
    done = subprocess.run(
        [sys.executable, "-c", forgetful],
        timeout=PATIENCE,
        capture_output=True,
        text=True,
    )
    assert (done.returncode, done.stderr) == (0, "")


# What there is not


def test_the_domain_is_that_of_the_environment_unless_one_is_given(monkeypatch):
    for domain, said in (
        ("0", None),
        ("", None),
        ("233", "ROS_DOMAIN_ID .* 0 to 232, got 233"),
        ("x", "got x"),
    ):
        monkeypatch.setenv("ROS_DOMAIN_ID", domain)
        with pytest.raises(ValueError, match=said) if said else nullcontext():
            Dds().close()
    monkeypatch.setenv("ROS_DOMAIN_ID", str(DOMAIN))
    poses = []
    with closing(Dds()) as here, closing(Dds(DOMAIN)) as there:
        there.hear("odom", ODOMETRY, poses.append)
        send = here.speak("odom", ODOMETRY)
        eventually(
            lambda: poses, lambda: send(make_odometry(here.make, 1.0, 2.0, 3.0, 0.5))
        )


@pytest.mark.parametrize(
    ("where", "said"),
    [
        ({"domain": 233}, "domain must be a whole number from 0 to 232, got 233"),
        ({"domain": -1}, "from 0 to 232, got -1"),
        ({"domain": "0"}, "from 0 to 232, got '0'"),
        (
            {"interface": "no_such0"},
            "the network interface 'no_such0' cannot be used; give the name or the IPv4 address",
        ),
        ({"interface": "192.0.2.254"}, "'192.0.2.254' cannot be used"),
        ({"interface": "größe"}, "'größe' cannot be used"),
        ({"interface": ""}, "'' cannot be used"),
        ({"interface": None}, "None cannot be used"),
        (
            {"peers": "robot"},
            r"peers must be a list of names or addresses, as in \['robot'\]",
        ),
        ({"peers": ["not a machine"]}, "no computer is called 'not a machine'; give"),
        ({"peers": [""]}, "no computer is called ''"),
        ({"peers": [5]}, "no computer is called 5"),
        (
            {"peers": ["192.0.2.7"]},
            "192.0.2.7 is not reached over 127.0.0.1; name the interface as well",
        ),
    ],
)
def test_a_domain_interface_or_peer_that_there_is_not_is_named(where, said):
    with pytest.raises(ValueError, match=said):
        connect("dds", **where)


def test_a_topic_or_kind_that_there_is_not_is_named(two):
    for topic in ("", "/", "my topic", "a//b", "5g", "~/odom", "größe"):
        with pytest.raises(
            ValueError, match="a topic is named as in 'odom' or '/robot1/odom'"
        ):
            two[0].speak(topic, TWIST)
    for action in (lambda kind: two[0].hear("odom", kind, print), two[0].make):
        with pytest.raises(
            ValueError,
            match=r"'nav_msgs/Odometri'; did you mean 'nav_msgs/Odometry'\? there are builti",
        ):
            action("nav_msgs/Odometri")


def test_without_cyclonedds_one_sentence_says_what_to_install(monkeypatch):
    monkeypatch.delitem(sys.modules, "rlrobot_ros.live.dds")
    monkeypatch.setitem(sys.modules, "cyclonedds", None)
    with pytest.raises(
        ImportError,
        match=r"cyclonedds is not installed: run pip install 'rlrobot-edu\[ros\]'",
    ):
        importlib.import_module("rlrobot_ros.live.dds")
