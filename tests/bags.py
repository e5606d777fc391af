"""Bags of drives of our own robots, written with rosbags, for the tests."""

import math
from collections.abc import Callable, Iterable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

import rlrobot_edu as rl
from rlrobot_edu.robots.mobile_base import MobileBase
from rlrobot_edu.task.robot_cards import LASER_RANGE, LASERS

SECOND = 10**9
TOPICS = {"odom": "/odom", "scan": "/laser_scan", "cmd_vel": "/cmd_vel"}
TYPES = {
    "odom": "nav_msgs/msg/Odometry",
    "scan": "sensor_msgs/msg/LaserScan",
    "cmd_vel": "geometry_msgs/msg/Twist",
}
FORMATS = ("ros1", "sqlite3", "mcap")
Event = tuple[
    int, str, dict[str, Any]
]  # time [ns], kind of topic, what the message says; "sent": when by its sender's clock [ns], if not at that time


def scan(
    ranges: Iterable[float],
    angle_min: float = 0.0,
    increment: float = math.pi / 4,
    **others: float,
) -> Any:
    """A laser scan as `laser_readings` takes it."""
    fields = {
        "angle_min": angle_min,
        "angle_increment": increment,
        "range_min": 0.05,
        "range_max": 10.0,
        **others,
    }
    return SimpleNamespace(ranges=np.array(list(ranges), np.float32), **fields)


def rim_scan(robot: MobileBase) -> dict[str, Any]:
    """The eight beams of a Giraff, whose lasers all look away from its middle, as a laser scan from there."""
    rays = (robot.readings[laser] for laser in LASERS)
    return vars(
        scan(
            math.inf if ray == LASER_RANGE else ray + robot.chassis.radius
            for ray in rays
        )
    )


def full_scan(robot: MobileBase, rays: int = 720) -> dict[str, Any]:
    """What a scanner would see from the point between the robot's wheels."""
    return vars(scan(robot.look_around(rays), 0.0, 2 * math.pi / rays))


def pose(robot: MobileBase) -> dict[str, Any]:
    """Odometry of the point between the robot's wheels."""
    theta, axle = robot.readings["theta"], robot.chassis.axle
    x, y = (
        robot.readings[name] + axle * part(theta)
        for name, part in (("x", math.cos), ("y", math.sin))
    )
    return {"x": x, "y": y, "theta": theta}


def drive(
    task: str,
    steps: int,
    seed: int = 0,
    see: Callable[[MobileBase], dict[str, Any]] = rim_scan,
) -> tuple[list[Event], rl.Recording]:
    """A robot that acts at random: what ROS would have told of it, one message of each kind a step, and the steps."""
    env = rl.make_env(task, seed=seed)
    task = env.unwrapped.task
    rng, events, rows = np.random.default_rng(seed), [], []
    env.reset()
    robot = env.unwrapped.robot
    for i in range(steps + 1):
        now = round((1000 + i * task.step_time) * SECOND)
        events += [(now, "odom", pose(robot)), (now, "scan", see(robot))]
        if i == steps:
            break
        a, s = int(rng.integers(task.actions.n)), env.unwrapped.state
        v, omega = robot.chassis.twist(task.command_for(a))
        events.append((now, "cmd_vel", {"v": v, "omega": omega}))
        _, r, terminated, truncated, info = env.step(a)
        rows.append((s, a, r, info["state"], terminated, truncated))
    transitions = rl.read_recording("wander_1k").transitions._make(
        map(np.array, zip(*rows, strict=True))
    )
    return events, rl.Recording(
        transitions, rl.record(rl.Agent(env), env, 1).source, task
    )


def write_bag(
    path: Path,
    form: str,
    events: Iterable[Event],
    topics: dict[str, str] | None = None,
    stamped: bool = False,
) -> Path:
    """Write a bag in one of `FORMATS`; returns its path."""
    from rosbags import rosbag1, rosbag2
    from rosbags.typesys import Stores, get_typestore

    topics = TOPICS if topics is None else topics
    is_ros1 = form == "ros1"
    store = get_typestore(Stores.ROS1_NOETIC if is_ros1 else Stores.ROS2_JAZZY)
    path = path / (f"{form}.bag" if is_ros1 else form)
    if is_ros1:
        writer = rosbag1.Writer(path)
    else:
        plugin = (
            rosbag2.StoragePlugin.SQLITE3
            if form == "sqlite3"
            else rosbag2.StoragePlugin.MCAP
        )
        writer = rosbag2.Writer(path, version=9, storage_plugin=plugin)
    types = TYPES | ({"cmd_vel": "geometry_msgs/msg/TwistStamped"} if stamped else {})
    with writer:
        there = {
            kind: writer.add_connection(topic, types[kind], typestore=store)
            for kind, topic in topics.items()
        }
        for time, kind, said in events:
            if kind in topics:
                message = _message(store.types, types[kind], time, said, is_ros1)
                serialize = store.serialize_ros1 if is_ros1 else store.serialize_cdr
                writer.write(there[kind], time, serialize(message, types[kind]))
    return path


def _message(
    types: dict[str, Any], name: str, time: int, said: dict[str, Any], is_ros1: bool
) -> Any:
    """A message of this type."""

    def make(kind: str, *given: Any) -> Any:
        return types[kind](*given)

    def vector(x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Any:
        return make("geometry_msgs/msg/Vector3", x, y, z)

    sent = said.get("sent", time)
    stamp = make("builtin_interfaces/msg/Time", sent // SECOND, sent % SECOND)
    header = make("std_msgs/msg/Header", *([0] if is_ros1 else []), stamp, "base_link")
    if name.startswith("sensor_msgs"):
        end = said["angle_min"] + said["angle_increment"] * (len(said["ranges"]) - 1)
        angles = (said["angle_min"], end, said["angle_increment"])
        nothing = np.zeros(0, np.float32)
        return make(
            name,
            header,
            *angles,
            0.0,
            0.1,
            said["range_min"],
            said["range_max"],
            said["ranges"],
            nothing,
        )
    if name.startswith("nav_msgs"):
        half = said["theta"] / 2
        q = make(
            "geometry_msgs/msg/Quaternion", 0.0, 0.0, math.sin(half), math.cos(half)
        )
        place = make(
            "geometry_msgs/msg/Pose",
            make("geometry_msgs/msg/Point", said["x"], said["y"], 0.0),
            q,
        )
        covariance = np.zeros(36)
        velocity = make("geometry_msgs/msg/Twist", vector(), vector())
        posed = make("geometry_msgs/msg/PoseWithCovariance", place, covariance)
        moving = make("geometry_msgs/msg/TwistWithCovariance", velocity, covariance)
        return make(name, header, "base_link", posed, moving)
    told = make(
        "geometry_msgs/msg/Twist",
        vector(said["v"], said.get("aside", 0.0)),
        vector(z=said["omega"]),
    )
    return told if name.endswith("Twist") else make(name, header, told)
