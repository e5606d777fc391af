"""What a robot tells over its topics: one message of each, and the picture of a scan."""

import math
import queue
from typing import Any

import numpy as np
from matplotlib.ticker import MaxNLocator

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREY,
    ORANGE,
    SKY,
    Picture,
    legend_below,
)
from rlrobot_edu.robots.chassis import Chassis
from rlrobot_edu.task.robot_cards import LASERS
from rlrobot_ros.live.rosbridge import Rosbridge
from rlrobot_ros.messages import LASER_SCAN, ODOMETRY
from rlrobot_ros.scan import Mounting, laser_readings, measured

PATIENCE = 20.0  # how long a message is waited for [s]
NOTHING = 0.1  # so far beyond the end of a laser there is nothing [m]
AHEAD = math.pi / 3  # to each side of straight ahead [rad]


def listen(address: str) -> tuple[Any, Any]:
    """One message of odometry and one scan of the robot behind rosbridge at that address.

    Raises ConnectionError if nobody is there, queue.Empty if nothing is said.
    """
    connection = Rosbridge(address)
    odometry: queue.SimpleQueue[Any] = queue.SimpleQueue()
    scans: queue.SimpleQueue[Any] = queue.SimpleQueue()
    try:
        connection.subscribe("odom", ODOMETRY, odometry.put)
        connection.subscribe("laser_scan", LASER_SCAN, scans.put)
        return odometry.get(timeout=PATIENCE), scans.get(timeout=PATIENCE)
    finally:
        connection.close()


def scan_finding(ends: dict[str, tuple[float, float]], scan: Any) -> str:
    """Which lasers end before anything was met in their direction. ends: (x, y) from the scanner, by laser"""
    angle_min, increment, ranges = measured(scan)[:3]
    hidden = []
    for laser, (x, y) in ends.items():
        ray = round((math.atan2(y, x) - angle_min) / increment) % len(ranges)
        if ranges[ray] > math.hypot(x, y) + NOTHING:
            hidden.append(laser.removeprefix("laser_").replace("_", " "))
    if not hidden:
        return "Each of the lasers ends at what the scanner met"
    verb = "ends" if len(hidden) == 1 else "end"
    said = f"{len(hidden)} of {len(ends)} lasers {verb} in the middle of nothing"
    return f"{said}, for what lies behind is hidden: {', '.join(hidden)}"


def plot_scan(scan: Any, chassis: Chassis) -> Picture:
    """A scan around its scanner, midway between the wheels, and the lasers that the toolkit makes of it.

    Straight ahead is up.
    """
    angle_min, increment, ranges = measured(scan)[:3]
    angles = angle_min + increment * np.arange(len(ranges))
    figure = Picture(figsize=(6.2, 6.8))
    ax = figure.subplots(subplot_kw={"projection": "polar"})
    ax.set_theta_zero_location("N")
    far = 1.2 * ranges[np.isfinite(ranges)].max(initial=0.1)
    free = (
        np.append(angles, angles[0] + 2 * np.pi),
        np.minimum(np.append(ranges, ranges[0]), far),
    )
    ax.fill(*free, color=SKY, alpha=0.25, linewidth=0, label="seen to be free")
    for side, label in ((-AHEAD, None), (AHEAD, "between these two lines: ahead")):
        ax.plot([side, side], [0, far], ":", color=BLACK, linewidth=1.5, label=label)
    ax.plot(
        angles,
        ranges,
        ".",
        color=GREY,
        markersize=4,
        zorder=12,
        label=f"{len(ranges)} rays: what each met",
    )
    told, ends = [], {}
    for laser, reading in laser_readings(scan, chassis, Mounting()).items():
        x, y, towards = chassis.lasers[LASERS.index(laser)]
        x -= chassis.axle
        end = (x + reading * math.cos(towards), y + reading * math.sin(towards))
        ends[laser] = end
        way = np.array([(x, y), end])
        ax.plot(
            np.arctan2(way[:, 1], way[:, 0]), np.hypot(*way.T), "-o", color=ORANGE, markersize=5, linewidth=2,
            label="the 8 lasers of the task" if not told else None,
        )  # fmt: skip
        told.append(f"{laser.removeprefix('laser_').replace('_', ' ')} {reading:.2f} m")
        label = (math.atan2(end[1], end[0]), math.hypot(*end) + 0.14 * far)
        box = {
            "facecolor": "white",
            "edgecolor": ORANGE,
            "boxstyle": "round,pad=0.15",
        }
        ax.annotate(
            f"{reading:.2f} m",
            label,
            color=BLACK,
            ha="center",
            va="center",
            bbox=box,
            zorder=9,
        )
    rim = chassis.radius * np.exp(1j * np.linspace(0, 2 * np.pi, 60)) - chassis.axle
    ax.plot(
        np.angle(rim),
        np.abs(rim),
        color=BLUE,
        linewidth=2,
        linestyle="--",
        label="circle around the robot",
    )
    ax.set(rmax=far)
    note = "directions (°), and distances from the scanner (m)"
    figure.headline(scan_finding(ends, scan), note)
    ax.set_rlabel_position(22)
    ax.yaxis.set_major_locator(MaxNLocator(4))
    legend_below(figure, 2)
    figure.alt = f"A scan of {len(ranges)} rays all round the robot, and eight lasers made of it: {'; '.join(told)}."
    return figure
