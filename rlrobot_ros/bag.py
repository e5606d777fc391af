"""Drives in bags of ROS 1 and ROS 2 as recordings."""

import re
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

from rlrobot_edu.checks import check_text, describe_error
from rlrobot_edu.files import check_path
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.recording import Recording
from rlrobot_edu.models.source import THIS_COMPUTER, Source
from rlrobot_edu.robots.chassis import Chassis
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task
from rlrobot_ros.drive import transitions_of
from rlrobot_ros.drive_report import DriveReport
from rlrobot_ros.messages import pose_of, stamp_of, velocity_of
from rlrobot_ros.motions import Motions
from rlrobot_ros.odometry import pose_readings
from rlrobot_ros.received import SECOND, Drive, Track
from rlrobot_ros.scan import Mounting, measured

STORAGE = (".db3", ".mcap")  # what the files of a bag of ROS 2 end with
KINDS = {
    "odom": ("nav_msgs/msg/Odometry",),
    "scan": ("sensor_msgs/msg/LaserScan",),
    "cmd_vel": ("geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped"),
}


class BagRecording(Recording):
    """A recording made from a bag. It is a `Recording` like any other.

    report: how much of the drive became steps, and why the rest did not
    """

    def __init__(
        self, transitions: Transitions, source: Source, task: Task, report: DriveReport
    ) -> None:
        super().__init__(transitions, source, task)
        self.report = report


@suggests_keywords
def recording_from_bag(
    path: str | Path,
    task: str | Path | Task,
    *,
    odom: str = "odom",
    scan: str = "laser_scan",
    cmd_vel: str = "cmd_vel",
    mounting: tuple[float, ...] = Mounting(),
    tolerance: float = 0.1,
) -> BagRecording:
    """The drive in a bag of ROS 1 or ROS 2 as a recording of a task.

    Parameters
    ----------
    path : str or Path
        A ``.bag`` of ROS 1, or the folder of a bag of ROS 2 (sqlite3 or mcap) or a file in it, also without its
        metadata.yaml.
    task : str, Path or Task
        The task that gives the drive its states, actions and rewards; its robot must be one on wheels.
    odom, scan, cmd_vel : str
        Names of the topics: of type Odometry, LaserScan, and Twist or TwistStamped.
    mounting : tuple of float, float, float, bool, float
        Where the scanner is: how far ahead of the point midway between the wheels and to its left [m], the direction
        of its angle 0 to the left from straight ahead [rad], and whether it hangs upside down. A fifth value is the one
        that it gives where nothing is within its range, if not infinity: 0, NaN, or any number above its range_max.
    tolerance : float
        How far a Twist may be from an action's motion, as part of the task's largest speed and largest turning.

    Returns
    -------
    BagRecording
        A `Recording` with a `report` on the messages that could not be used.

    Raises
    ------
    ValueError
        In one sentence, for a bag that is damaged, lacks a topic, or holds no step of the task.
    FileNotFoundError
        If there is no such bag.
    ImportError
        If rosbags is missing; it says what to install.

    Notes
    -----
    The time of a message is the time at which it was received. A step begins when its command comes and lasts the
    task's `step_time` (±10 %, if another command comes then). The state before and after it, and its reward, come from
    the latest odometry and scan. A step is dropped if these do not say enough, if they are older than half a second and
    than one and a half steps, or if their time stamps show that a clock was set within the step. A Twist that is not
    like any action is dropped. If several actions have the same motion, the one whose outputs are the wheels' speeds
    counts, or otherwise the first. After a gap a new episode begins.
    """
    task = load_task(task)
    path = check_path(path)
    place = Mounting.of(mounting)
    motions = Motions(task, tolerance)
    with _opened(path) as reader:
        topics = _find(reader, path, {"odom": odom, "scan": scan, "cmd_vel": cmd_vel})
        drive = _read(reader, path, topics, motions.chassis, place)
    try:
        transitions, report = transitions_of(task, drive, motions, list(topics))
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from error
    return BagRecording(
        transitions, Source.of_task(task, **THIS_COMPUTER), task, report
    )


@contextmanager
def _opened(path: Path) -> Iterator[Any]:
    """A reader of the bag. Raises ValueError if it cannot be read, ImportError if rosbags is missing."""
    try:
        from rosbags.highlevel import AnyReader
        from rosbags.typesys import Stores, get_typestore
    except ImportError:
        raise ImportError(
            "rosbags is not installed: run pip install rosbags; everything else works without it"
        ) from None
    if not path.exists():
        raise FileNotFoundError(f"{path}: there is no such bag")
    # Older bags of ROS 2 do not define their messages, which have been the same ever since.
    typestore = get_typestore(Stores.ROS2_HUMBLE)
    reader = None
    faults: list[Exception] = []
    for paths in _ways_in(path):
        try:
            reader = AnyReader(paths, default_typestore=typestore)
            reader.open()
            break
        except Exception as error:  # a damaged file may raise anything
            reader = None
            faults.append(error)
    if reader is None:
        raise ValueError(
            f"{path}: this is not a whole bag of ROS 1 or ROS 2 ({describe_error(faults[0])})"
        ) from faults[0]
    with closing(reader):
        yield reader


def _ways_in(path: Path) -> Iterator[list[Path]]:
    """The files to be read together for the bag at this path; if they cannot be read, the next ones may.

    A bag of ROS 2 is a folder with a description, ``metadata.yaml``. If that was lost, or does not fit its files any
    more, they can be read without it, unless they are compressed or one of them is missing.
    """
    is_in_folder = path.suffix in STORAGE and (path.parent / "metadata.yaml").is_file()
    yield [path.parent if is_in_folder else path]
    if is_in_folder:
        yield [path]
    if path.is_dir():
        files = sorted(file for file in path.iterdir() if file.suffix in STORAGE)
        if files and len(files) >= len(_listed_in(path / "metadata.yaml")):
            yield files


def _listed_in(description: Path) -> set[str]:
    """The names of the bag's files in its description."""
    if not description.is_file():
        return set()
    text = description.read_text(encoding="utf-8", errors="replace")
    return set(re.findall(r"[^\s\"'/\\]+\.(?:db3|mcap)\b", text))


def _find(reader: Any, path: Path, topics: dict[str, str]) -> dict[str, list[Any]]:
    """Connections of the bag by the name of the topic. Raises ValueError if one is missing or of another type."""
    found = {}
    for argument, topic in topics.items():
        check_text(argument, topic)
        name = topic.strip("/")
        connections = [c for c in reader.connections if c.topic.strip("/") == name]
        kinds = {c.msgtype for c in connections}
        if not kinds or not kinds <= set(KINDS[argument]):
            there = {f"{c.topic} ({c.msgtype})" for c in reader.connections}
            raise ValueError(
                f"{path}: {argument}={topic!r} must name a topic of type {' or '.join(KINDS[argument])}; "
                f"the topics in this bag are: {', '.join(sorted(there)):.2000}"
            )
        found[connections[0].topic] = connections
    return found


def _read(
    reader: Any,
    path: Path,
    topics: dict[str, list[Any]],
    chassis: Chassis,
    place: Mounting,
) -> Drive:
    """All messages of these topics, of odometry, scan and command, as numbers in order of time."""
    drive = Drive()
    odom, scan, cmd_vel = topics
    tracks: dict[str, Track[Any]] = {
        odom: drive.poses,
        scan: drive.scans,
        cmd_vel: drive.twists,
    }

    def read(topic: str, message: Any) -> Any:
        if topic == odom:
            return pose_readings(*pose_of(message), chassis)
        if topic == scan:
            return drive.lasers_in(measured(message, place.far), chassis, place)
        return velocity_of(message)

    connections = [c for found in topics.values() for c in found]
    try:
        for connection, time, raw in reader.messages(connections):
            topic = connection.topic
            stamp = 0
            try:
                message = reader.deserialize(raw, connection.msgtype)
                stamp = _stamp(message)
                value = read(topic, message)
            except Exception as error:  # damaged bytes may raise anything
                value = tracks[topic].nothing
                is_ours = isinstance(error, ValueError)
                drive.add_fault(topic, str(error) if is_ours else describe_error(error))
            tracks[topic].add(time, value, stamp)
    except Exception as error:  # so may a damaged file
        raise ValueError(
            f"{path}: this bag is damaged ({describe_error(error)}); copy it again"
        ) from error
    return drive


def _stamp(message: Any) -> int:
    """When the message was sent, by its sender's clock [ns]; 0 if it does not say."""
    try:
        return round(stamp_of(message) * SECOND)
    except ValueError:
        return 0
