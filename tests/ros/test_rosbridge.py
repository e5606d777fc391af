"""Messages go over rosbridge both ways, in its own words; no fault of the other side's kills or hangs anything."""

import contextlib
import json
import math
import queue
import socket
import subprocess
import sys
import threading
import time

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from waiting import eventually

from rlrobot_edu.robots.chassis import CHASSIS
from rlrobot_edu.task.robot_cards import LASERS
from rlrobot_ros import messages
from rlrobot_ros.messages import LASER_SCAN, ODOMETRY, TWIST, TWIST_STAMPED
from rlrobot_ros.scan import Mounting, laser_readings

pytest.importorskip(
    "websockets", reason="websockets is missing: pip install websockets"
)
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect as raw_connect
from websockets.sync.server import serve

from rlrobot_ros.live import rosbridge_server
from rlrobot_ros.live.rosbridge import Rosbridge
from rlrobot_ros.live.rosbridge_server import RosbridgeServer

PATIENCE = 60.0  # [s] on a busy machine
# a sign of life that the connection sends meanwhile draws a random number
signs_of_life = pytest.mark.filterwarnings(
    "ignore:Do not use the `random` module inside strategies"
)


def twist(v=0.3, omega=-0.5):
    return messages.make_twist(v, omega)


pytestmark = pytest.mark.usefixtures("nothing_is_left_running")


class RawServer:
    """A websocket that keeps what it is told and says what it is asked to say; it knows nothing of rosbridge."""

    def __init__(self, port=0):
        self.told, self.connections = queue.Queue(), queue.Queue()
        self._server = serve(self._attend, "127.0.0.1", port, close_timeout=1)
        self.port = self._server.socket.getsockname()[1]
        self.address = f"ws://127.0.0.1:{self.port}"
        self._thread = threading.Thread(target=self._server.serve_forever)
        self._thread.start()

    def _attend(self, connection):
        self.connections.put(connection)
        for text in connection:
            self.told.put(json.loads(text))

    def next(self):
        return self.told.get(timeout=PATIENCE)

    def close(self):
        self._server.shutdown()
        self._thread.join()


@pytest.fixture
def server():
    with contextlib.closing(RawServer()) as server:
        yield server


@pytest.fixture
def link(server):
    with contextlib.closing(Rosbridge(server.address)) as link:
        link.server = server.connections.get(timeout=PATIENCE)
        yield link


@pytest.fixture
def router():
    with RosbridgeServer(0) as router:
        yield router


class RawClient:
    """A websocket that says and hears words of the protocol as they are."""

    def __init__(self, router):
        self._socket = raw_connect(
            router.address, proxy=None, close_timeout=1
        ).__enter__()
        self.close = self._socket.close

    def say(self, text="", **said):
        self._socket.send(text or json.dumps(said))

    def hear(self, timeout=PATIENCE):
        return json.loads(self._socket.recv(timeout))

    def hears_nothing_more(self):
        """Whether the answer to what it says now is the next thing that it hears."""
        self.say(op="no such op", topic="/odom")
        return "no such op" in self.hear()["msg"]


@pytest.fixture
def raw(router):
    with contextlib.closing(RawClient(router)) as raw:
        yield raw


# The client's words


def test_the_client_says_the_protocols_own_words(server, link):
    link.subscribe("/odom", ODOMETRY, print)
    assert server.next() == {
        "op": "subscribe", "topic": "/odom", "type": "nav_msgs/Odometry", "queue_length": 1, "throttle_rate": 0,
    }  # fmt: skip
    drive = link.advertise("/cmd_vel", TWIST)
    assert server.next() == {
        "op": "advertise",
        "topic": "/cmd_vel",
        "type": "geometry_msgs/Twist",
    }
    drive(twist())
    vectors = {
        "linear": {"x": 0.3, "y": 0.0, "z": 0.0},
        "angular": {"x": 0.0, "y": 0.0, "z": -0.5},
    }
    assert server.next() == {"op": "publish", "topic": "/cmd_vel", "msg": vectors}


def test_a_stamped_twist_goes_without_its_time_and_odometry_with_it(server, link):
    link.advertise("/cmd_vel", TWIST_STAMPED)(messages.make_twist_stamped(0.1, 0.2))
    link.advertise("/odom", ODOMETRY)(messages.make_odometry(12.5, 1.0, 2.0, 0.5))
    told = [server.next() for _ in range(4)]
    assert told[1]["msg"]["header"] == {"frame_id": "base_link"}
    assert told[1]["msg"]["twist"]["linear"]["x"] == 0.1
    assert told[3]["msg"]["header"]["stamp"] == {"sec": 12, "nanosec": 500_000_000}


def test_infinity_among_ranges_means_that_nothing_was_met_and_null_that_nothing_is_known(
    link,
):
    scans = []
    link.subscribe("/scan", LASER_SCAN, scans.append)
    ranges = ["null", "NaN", "Infinity", "1e999", "0.8", "0.8", "0.8", "0.8"]
    link.server.send(
        '{"op": "publish", "topic": "/scan", "msg": {"angle_min": 0.0, "angle_increment": 0.7853981633974483, '
        f'"range_min": 0.05, "range_max": 10.0, "ranges": [{", ".join(ranges)}]}}}}'
    )
    eventually(lambda: scans)
    told = laser_readings(scans[0], CHASSIS["giraff"], Mounting(far=math.nan))
    readings = laser_readings(scans[0], CHASSIS["giraff"], Mounting())
    scans[0].ranges = [math.inf] * 4 + [0.8] * 4
    free = laser_readings(scans[0], CHASSIS["giraff"], Mounting())
    assert told == free and readings == {laser: free[laser] for laser in LASERS[2:]}
    assert len(set(readings.values())) == 2


@pytest.mark.parametrize(
    "stamp", [{"secs": 3, "nsecs": 250_000_000}, {"sec": 3, "nanosec": 250_000_000}]
)
def test_the_times_of_ros_1_and_of_ros_2_are_read(link, stamp):
    heard = []
    link.subscribe("/odom", ODOMETRY, heard.append)
    pose = {
        "position": {"x": 1, "y": 2, "z": 0},
        "orientation": {"x": 0, "y": 0, "z": 0, "w": 1},
    }
    said = {
        "op": "publish",
        "topic": "/odom",
        "msg": {"header": {"stamp": stamp}, "pose": {"pose": pose}},
    }
    link.server.send(json.dumps(said))
    link.server.send(json.dumps(said).encode())
    eventually(lambda: len(heard) == 2)
    assert (messages.stamp_of(heard[0]), messages.pose_of(heard[1])) == (
        3.25,
        (1.0, 2.0, 0.0),
    )


# Faults of the server

GARBAGE = [
    "", "no json", "[]", "5", "null", "{}", '{"op": 1}', '{"op": "fly"}', '{"op": "publish"}', "[" * 100_000, b"\xff",
    '{"op": "publish", "topic": "/unasked", "msg": {}}', '{"op": "publish", "topic": "/odom"}',
    '{"op": "publish", "topic": ["/odom"], "msg": {}}',
    '{"op": "publish", "topic": "/odom", "msg": {"x": ' + "9" * 5000 + "}}", '{"op": {}, "topic": "/odom", "msg": {}}',
]  # fmt: skip


def test_what_cannot_be_understood_is_passed_over(link):
    heard = []
    link.subscribe("/odom", ODOMETRY, heard.append)
    for text in GARBAGE:
        link.server.send(text)
    link.server.send('{"op": "publish", "topic": "/odom", "msg": {"x": 1}}')
    eventually(lambda: heard)
    assert (heard[0].x, link.lost) == (1, None)


JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(),
    lambda parts: (
        st.lists(parts)
        | st.dictionaries(st.text() | st.sampled_from(["op", "topic", "msg"]), parts)
    ),
    max_leaves=8,
)
SAID = st.fixed_dictionaries(
    {},
    optional={
        "op": JSON | st.sampled_from(["publish", "status"]),
        "topic": JSON | st.just("/odom"),
        "msg": JSON,
        "level": JSON | st.just("error"),
    },
)


@signs_of_life
def test_whatever_json_the_server_sends_the_client_lives_on():
    heard = queue.Queue()
    with (
        contextlib.closing(RawServer()) as server,
        contextlib.closing(Rosbridge(server.address)) as link,
    ):
        link.subscribe(
            "/odom",
            ODOMETRY,
            lambda message: (heard.put(message), messages.pose_of(message)),
        )
        told = server.connections.get(timeout=PATIENCE)

        @settings(max_examples=100, deadline=None)
        @given(JSON | SAID)
        def lives_on(value):
            told.send(json.dumps(value))
            told.send('{"op": "publish", "topic": "/odom", "msg": {"is_last": true}}')
            while not hasattr(heard.get(timeout=PATIENCE), "is_last"):
                pass
            assert link.lost is None

        lives_on()


def test_the_latest_complaints_are_kept_and_so_is_what_went_wrong_in_hearing(link):
    link.subscribe("/odom", ODOMETRY, messages.pose_of)
    for i in range(20):
        link.server.send(
            json.dumps({"op": "status", "level": "error", "msg": f"complaint {i}"})
        )
    link.server.send(
        json.dumps({"op": "status", "level": "info", "msg": "all is well"})
    )
    link.server.send('{"op": "publish", "topic": "/odom", "msg": {}}')
    eventually(lambda: link.errors and "Odometry" in link.errors[-1])
    assert link.errors[-2] == "complaint 19"
    assert len(link.errors) < 10
    assert link.lost is None


def test_a_large_message_is_taken(link):
    heard = []
    link.subscribe("/scan", LASER_SCAN, heard.append)
    link.server.send(
        json.dumps(
            {
                "op": "publish",
                "topic": "/scan",
                "msg": {"ranges": [1.23456789] * 400_000},
            }
        )
    )
    eventually(lambda: heard)
    assert len(heard[0].ranges) == 400_000


@pytest.mark.parametrize("by_accident", [False, True])
def test_a_lost_connection_is_said_in_one_sentence_and_a_new_one_can_be_made(
    server, link, by_accident
):
    drive = link.advertise("/cmd_vel", TWIST)
    if by_accident:
        link.server.socket.shutdown(socket.SHUT_RDWR)
    server.close()
    eventually(lambda: link.lost)
    with pytest.raises(ConnectionError) as error:
        drive(twist())
    assert str(error.value) == link.lost
    assert server.address in link.lost
    assert "connect again" in link.lost
    with pytest.raises(ConnectionError):
        link.subscribe("/odom", ODOMETRY, print)
    with (
        contextlib.closing(RawServer(server.port)) as again,
        contextlib.closing(Rosbridge(server.address)) as anew,
    ):
        anew.advertise("/cmd_vel", TWIST)(twist())
        assert [again.next()["op"] for _ in range(2)] == ["advertise", "publish"]


@pytest.fixture
def hanging():
    """A server that says yes to a websocket and nothing ever after; it takes nothing either."""
    with socket.create_server(("127.0.0.1", 0)) as listening:
        taken = []

        def greet():
            from websockets.server import ServerProtocol

            connected, _ = listening.accept()
            taken.append(connected)
            protocol = ServerProtocol()
            while not (events := protocol.events_received()):
                protocol.receive_data(connected.recv(10_000))
            protocol.send_response(protocol.accept(events[0]))
            connected.sendall(b"".join(protocol.data_to_send()))

        thread = threading.Thread(target=greet)
        thread.start()
        yield f"ws://127.0.0.1:{listening.getsockname()[1]}"
        thread.join()
        for connected in taken:
            connected.close()


def test_a_server_that_hangs_does_not_hang_the_client(hanging):
    link = Rosbridge(hanging)
    begin = time.monotonic()
    link.close()
    link.close()
    assert time.monotonic() - begin < 15
    assert "closed here" in link.lost


def test_a_server_that_takes_nothing_any_more_is_given_up(hanging):
    link = Rosbridge(hanging)
    drive = link.advertise("/cmd_vel", TWIST)
    with pytest.raises(ConnectionError, match="is lost"):
        for _ in range(10_000):
            drive({"text": "a" * 100_000})
    link.close()


def test_closing_while_another_thread_is_stuck_in_speaking_is_prompt(hanging):
    link = Rosbridge(hanging)
    drive = link.advertise("/cmd_vel", TWIST)
    count = iter(range(10**9))
    sent = [0]

    def speak():
        with contextlib.suppress(ConnectionError):
            while True:
                drive({"text": "a" * 100_000})
                sent[0] = next(count)

    thread = threading.Thread(target=speak)
    thread.start()
    eventually(lambda: sent[0] > 5)
    begin = time.monotonic()
    link.close()
    assert time.monotonic() - begin < 15
    thread.join(PATIENCE)
    assert not thread.is_alive()


def test_what_was_said_before_closing_arrives_and_nothing_can_be_said_after(
    server, link
):
    drive = link.advertise("/cmd_vel", TWIST)
    for i in range(500):
        drive(twist(v=i))
    link.close()
    with pytest.raises(ConnectionError, match="closed here"):
        drive(twist())
    said = [server.next() for _ in range(501)]
    assert [s["msg"]["linear"]["x"] for s in said[1:]] == list(range(500))


def test_a_callback_may_close_the_connection(link):
    link.subscribe("/odom", ODOMETRY, lambda _: link.close())
    link.server.send('{"op": "publish", "topic": "/odom", "msg": {}}')
    eventually(lambda: link.lost)
    assert not link.errors


def test_many_threads_may_speak_at_once(server, link):
    def speak(i):
        drive = link.advertise(f"/topic_{i}", TWIST)
        for n in range(50):
            drive({"i": i, "n": n})

    threads = [threading.Thread(target=speak, args=(i,)) for i in range(8)]
    for thread in threads:
        thread.start()
    said = [server.next() for _ in range(8 * 51)]
    for thread in threads:
        thread.join()
    for i in range(8):
        assert [
            s["msg"]["n"] for s in said if s["op"] == "publish" and s["msg"]["i"] == i
        ] == list(range(50))


# Nobody there


@pytest.mark.parametrize(
    "address",
    ["http://127.0.0.1:9090", "127.0.0.1:9090", "ws://127.0.0.1", "ws://:9090", "ws://robot:port", "", None, 9090,
     "ws://a robot:9090"],
)  # fmt: skip
def test_what_is_no_address_is_refused_with_one_that_is(address):
    with pytest.raises(ValueError, match=r"ws://192\.168\.0\.10:9090") as error:
        Rosbridge(address)
    assert repr(address) in str(error.value)


def test_where_nobody_is_one_sentence_says_how_to_start_rosbridge():
    with socket.create_server(("127.0.0.1", 0)) as taken:
        address = f"ws://127.0.0.1:{taken.getsockname()[1]}"
    with pytest.raises(ConnectionError, match="roslaunch rosbridge_server") as error:
        Rosbridge(address)
    assert address in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("name", ["RobotLink", "ServedRobot"])
def test_without_websockets_one_sentence_says_what_to_install(name):
    program = (
        f"import sys; sys.modules['websockets'] = None; from rlrobot_ros import {name}"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, timeout=600
    )
    said = done.stderr.splitlines()[-1]
    assert said.startswith("ImportError") and "pip install websockets" in said


def test_a_server_of_something_else_is_no_rosbridge():
    def answer():
        connected, _ = listening.accept()
        connected.recv(10_000)
        connected.sendall(b"HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\nhi")
        connected.close()

    with socket.create_server(("127.0.0.1", 0)) as listening:
        thread = threading.Thread(target=answer)
        thread.start()
        with pytest.raises(ConnectionError, match="no rosbridge answers"):
            Rosbridge(f"ws://127.0.0.1:{listening.getsockname()[1]}")
        thread.join()


def test_a_proxy_of_the_environment_is_not_asked(router, monkeypatch):
    for name in ("http_proxy", "https_proxy", "all_proxy", "HTTP_PROXY"):
        monkeypatch.setenv(name, "http://127.0.0.1:9")
    monkeypatch.delenv("no_proxy", raising=False)
    Rosbridge(router.address).close()


# The server


def test_the_server_speaks_the_protocol(router, raw):
    with contextlib.closing(RawClient(router)) as other:
        other.say(
            op="subscribe",
            id="s",
            topic="/cmd_vel",
            type="geometry_msgs/Twist",
            queue_length=1,
            throttle_rate=0,
        )
        assert other.hears_nothing_more()
        raw.say(op="advertise", id="a", topic="/cmd_vel", type="geometry_msgs/Twist")
        raw.say(op="publish", id="p", topic="/cmd_vel", msg={"linear": {"x": 1}})
        assert other.hear() == {
            "op": "publish",
            "topic": "/cmd_vel",
            "msg": {"linear": {"x": 1}},
        }
        assert raw.hears_nothing_more()
        assert other.hears_nothing_more()


def test_a_topic_is_the_same_with_and_without_a_slash_and_comes_as_it_was_asked_for(
    router, raw
):
    raw.say(op="subscribe", topic="odom", type="nav_msgs/Odometry")
    raw.say(op="publish", topic="/odom", msg={"x": 1})  # one hears oneself, too
    assert raw.hear() == {"op": "publish", "topic": "odom", "msg": {"x": 1}}


@pytest.mark.parametrize(
    ("said", "fault"),
    [
        ("no json", "Expecting value"),
        ("[1, 2]", "TypeError"),
        ("[" * 100_000, "recursion"),
        ('{"topic": "/odom"}', "'op'"),
        ('{"op": "call_service", "topic": "/rosapi"}', "unknown op 'call_service'"),
        ('{"op": "subscribe"}', "'topic'"),
        ('{"op": "subscribe", "topic": 5}', "AttributeError"),
        ('{"op": "publish", "topic": "/odom"}', "'msg'"),
    ],
)
def test_what_cannot_be_done_is_answered_and_the_connection_stays(raw, said, fault):
    raw.say(said)
    answer = raw.hear()
    assert (answer["op"], answer["level"]) == ("status", "error")
    assert fault in answer["msg"]
    assert raw.hears_nothing_more()


@signs_of_life
def test_whatever_json_a_client_says_the_server_serves_on():
    ops = st.sampled_from(["publish", "subscribe", "advertise"])
    said = st.fixed_dictionaries(
        {"op": ops | JSON}, optional={k: JSON for k in ("type", "id", "msg")}
    )
    topics = st.just("/odom") | JSON
    with RosbridgeServer(0) as router, contextlib.closing(RawClient(router)) as raw:

        @settings(max_examples=100, deadline=None)
        @given(
            JSON | st.builds(lambda one, topic: {**one, "topic": topic}, said, topics)
        )
        def serves_on(value):
            raw.say(json.dumps(value))
            raw.say(op="no such op", topic="/odom")
            while "no such op" not in str(raw.hear().get("msg")):
                pass

        serves_on()


def test_who_does_not_read_holds_up_nobody_and_is_disconnected(monkeypatch):
    monkeypatch.setitem(rosbridge_server.OPTIONS, "ping_interval", 0.2)
    monkeypatch.setitem(rosbridge_server.OPTIONS, "ping_timeout", 0.5)
    with (
        RosbridgeServer(0) as router,
        contextlib.closing(RawClient(router)) as raw,
        contextlib.closing(Rosbridge(router.address)) as robot,
        contextlib.closing(Rosbridge(router.address)) as link,
    ):
        raw.say(op="subscribe", topic="/scan", type="sensor_msgs/LaserScan")
        assert raw.hears_nothing_more()
        heard = queue.Queue()
        link.subscribe("/scan", LASER_SCAN, heard.put)
        publish = robot.advertise("/scan", LASER_SCAN)
        eventually(lambda: publish({"i": -1}) or heard.qsize())
        for i in range(2000):
            publish({"i": i, "ranges": [1.234567] * 720})
            while heard.get(timeout=PATIENCE).i < i:
                pass  # raw reads none of these
        eventually(lambda: len(router._subscribers["scan"]) == 1)


def test_who_does_not_read_does_not_hold_up_the_servers_end(router, raw):
    raw.say(op="subscribe", topic="/scan", type="sensor_msgs/LaserScan")
    for i in range(2000):
        raw.say(op="publish", topic="/scan", msg={"i": i, "ranges": [1.234567] * 720})
    with socket.create_connection(
        ("127.0.0.1", router.port)
    ):  # and one who says nothing
        begin = time.monotonic()
        router.close()
        router.close()
        assert time.monotonic() - begin < 20


def test_what_waits_for_a_client_still_comes_before_the_server_ends(router):
    heard, last = [], threading.Event()
    with contextlib.closing(Rosbridge(router.address)) as link:
        link.subscribe(
            "/odom",
            ODOMETRY,
            lambda message: (heard.append(message.i), time.sleep(0.001)),
        )
        link.subscribe("/last", ODOMETRY, lambda _: last.set())
        tell = link.advertise("/odom", ODOMETRY)
        for i in range(50):
            tell({"i": i})
        link.advertise("/last", ODOMETRY)({})
        assert last.wait(PATIENCE)
        router.close()
        eventually(lambda: link.lost)
        assert heard == list(range(50))


def test_only_this_computer_is_served(router):
    with pytest.raises(OSError):
        socket.create_connection(("127.0.0.2", router.port), timeout=1).close()


@pytest.mark.parametrize(
    "origin", ["http://evil.example", "http://localhost:8888", "null"]
)
def test_no_web_page_gets_in_wherever_it_comes_from(router, origin):
    with pytest.raises(InvalidStatus, match="403"):
        raw_connect(router.address, origin=origin, proxy=None).__enter__()
    Rosbridge(router.address).close()  # a program does


def test_many_who_do_not_read_are_ended_side_by_side(router):
    key = "GET / HTTP/1.1\r\nHost: x\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
    key += "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n"
    with contextlib.ExitStack() as clients:
        for _ in range(60):
            client = clients.enter_context(
                socket.create_connection(("127.0.0.1", router.port), timeout=PATIENCE)
            )
            client.sendall(key.encode())
            assert b"101 Switching" in client.recv(1000)
        begin = time.monotonic()
        router.close()
        assert (
            time.monotonic() - begin < 8
        )  # one after the other, a second for each few, it would be eleven


def test_a_port_that_is_taken_is_said_in_one_sentence(router):
    with pytest.raises(
        ConnectionError, match=f"port {router.port} is not free"
    ) as error:
        RosbridgeServer(router.port)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("port", [-1, 70_000, "9090", None, 90.5])
def test_what_is_no_port_is_refused(port):
    with pytest.raises(ValueError, match="from 0 to 65535"):
        RosbridgeServer(port)


def test_a_client_comes_back_to_a_router_that_was_started_again():
    with (
        RosbridgeServer(0) as router,
        contextlib.closing(Rosbridge(router.address)) as link,
    ):
        router.close()
        eventually(lambda: link.lost)
        with (
            RosbridgeServer(router.port) as again,
            contextlib.closing(Rosbridge(again.address)) as anew,
        ):
            heard = queue.Queue()
            anew.subscribe("/cmd_vel", TWIST, heard.put)
            anew.advertise("/cmd_vel", TWIST)(twist())
            assert messages.velocity_of(heard.get(timeout=PATIENCE)) == (0.3, 0.0, -0.5)


# Other processes

ROBOT = """
import sys
from rlrobot_ros import messages
from rlrobot_ros.live.rosbridge import Rosbridge
link = Rosbridge(sys.argv[1])
odom = link.advertise("/odom", messages.ODOMETRY)
def answer(command):
    v, _, omega = messages.velocity_of(command)
    odom(messages.make_odometry(1.5, v, omega, 0.0))
link.subscribe("/cmd_vel", messages.TWIST, answer)
print("ready", flush=True)
sys.stdin.read()
link.close()
"""

ROSLIBPY = """
import sys, threading, roslibpy
ros = roslibpy.Ros("127.0.0.1", int(sys.argv[1].rpartition(":")[2]))
ros.run(timeout=20)
odom = roslibpy.Topic(ros, "/odom", "nav_msgs/Odometry")
command = roslibpy.Topic(ros, "/cmd_vel", "geometry_msgs/Twist")
vector = lambda x, z: {"x": x, "y": 0.0, "z": z}
def answer(said):
    place = said["pose"]["pose"]["position"]
    command.publish(roslibpy.Message({"linear": vector(place["x"], 0.0), "angular": vector(0.0, place["y"])}))
command.advertise()
odom.subscribe(answer)
print("ready", flush=True)
sys.stdin.read()
ros.terminate()
"""


@contextlib.contextmanager
def process(program, address):
    """A Python process that runs until its input ends, after it has said that it is ready."""
    with subprocess.Popen(
        [sys.executable, "-c", program, address],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    ) as running:
        try:
            assert running.stdout.readline() == "ready\n"
            yield
        finally:
            running.communicate("", timeout=PATIENCE)
    assert running.returncode == 0


def test_a_robot_in_another_process_answers_each_command(router):
    with (
        contextlib.closing(Rosbridge(router.address)) as link,
        process(ROBOT, router.address),
    ):
        heard = queue.Queue()
        link.subscribe("/odom", ODOMETRY, heard.put)
        drive = link.advertise("/cmd_vel", TWIST)
        eventually(
            lambda: drive(twist(0.0, 0.0)) or heard.qsize()
        )  # till both have subscribed
        for i in range(1, 300):
            drive(twist(i, -i))
            while (pose := messages.pose_of(heard.get(timeout=PATIENCE)))[0] == 0:
                pass
            assert pose == (i, -i, 0.0)


def test_a_client_that_others_wrote_is_understood_and_understands(router):
    pytest.importorskip(
        "roslibpy", reason="roslibpy, another client of rosbridge, is not installed"
    )
    with (
        contextlib.closing(Rosbridge(router.address)) as link,
        process(ROSLIBPY, router.address),
    ):
        heard = []
        link.subscribe("/cmd_vel", TWIST, heard.append)
        tell = link.advertise("/odom", ODOMETRY)
        eventually(lambda: tell(messages.make_odometry(1.5, 0.25, -0.75, 0.0)) or heard)
        assert messages.velocity_of(heard[0]) == (0.25, 0.0, -0.75)
