"""The figures of lesson 17 on messages and on rehearsals."""

from collections.abc import Mapping, Sequence

from matplotlib.axes import Axes
from matplotlib.patches import FancyBboxPatch

from rlrobot_course.plots import BLACK, BLUE, CURVES, GREEN, ORANGE, VERMILION, Picture, chart, name_rows
from rlrobot_course.runs import mean_and_half

TOPICS = (  # name, type, what it says; and whether the robot is who says it
    ("odom", "Odometry", "where I have rolled to", True),
    ("laser_scan", "LaserScan", "how far each ray got", True),
    ("cmd_vel", "Twist", "drive at v, turn at ω", False),
)


def _box(ax: Axes, left: float, width: float, words: str, colour: str) -> None:
    box = FancyBboxPatch((left, 0.06), width, 0.88, boxstyle="round,pad=0.02", facecolor="white", edgecolor=colour)
    box.set_linewidth(2.5)
    ax.add_patch(box)
    ax.text(left + width / 2, 0.5, words, ha="center", va="center", fontsize=11, color=BLACK, linespacing=1.6)


def _arrow(ax: Axes, height: float, ends: tuple[float, float], to_the_right: bool) -> None:
    start, end = ends if to_the_right else ends[::-1]
    colour, dashes = (BLUE, "-") if to_the_right else (VERMILION, "--")
    arrow = {"arrowstyle": "-|>", "color": colour, "linewidth": 2, "linestyle": dashes, "mutation_scale": 16,
             "shrinkA": 0, "shrinkB": 0}  # fmt: skip
    ax.annotate("", (end, height), (start, height), arrowprops=arrow)


def plot_topics() -> Picture:
    """A robot, its three topics, the link, and the agent, with arrows in the direction in which messages go."""
    figure = Picture(figsize=(8.4, 2.9))
    ax = figure.subplots()
    ax.set(xlim=(0, 10), ylim=(0, 1), title="Three topics between a robot and its link")
    ax.axis("off")
    _box(ax, 0.1, 1.3, "robot", BLUE)
    _box(ax, 5.1, 1.6, "link\nRobotLink", GREEN)
    _box(ax, 8.5, 1.3, "agent", ORANGE)
    for height, (name, kind, says, from_robot) in zip((0.84, 0.5, 0.16), TOPICS, strict=True):
        _arrow(ax, height, (1.5, 5.0), from_robot)
        ax.text(3.25, height + 0.03, f"{name}: {says}", ha="center", va="bottom", fontsize=10, color=BLACK)
        ax.text(3.25, height - 0.03, f"a message of type {kind}", ha="center", va="top", fontsize=9, color=BLACK)
    for height, words, to_agent in ((0.62, "state, reward", True), (0.38, "action", False)):
        _arrow(ax, height, (6.8, 8.4), to_agent)
        ax.text(7.6, height + 0.04, words, ha="center", va="bottom", fontsize=9.5, color=BLACK)
    told = "; ".join(f"{name} ({kind}) {'from' if out else 'to'} the robot" for name, kind, _, out in TOPICS)
    figure.alt = f"Boxes robot, link and agent. Topics between robot and link: {told}. Link and agent exchange states, "
    figure.alt += "rewards and actions."
    return figure


def plot_rehearsals(earned: Mapping[str, Sequence[float]], title: str) -> Picture:
    """The mean reward of each group, with its 95 % interval, and a dot for each of its robots.

    earned: name of a group -> mean reward a step of each robot
    """
    n, told = len(next(iter(earned.values()))), []
    x = f"mean reward a step; diamond: mean of {n} robots with its 95 % interval"
    figure, ax = chart((7.4, 1.7 + 0.6 * len(earned)), x, "", title, grid="x")
    for i, ((name, values), (colour, _)) in enumerate(zip(earned.items(), CURVES, strict=False)):
        mean, half = mean_and_half(values)
        ax.plot(values, [i + 0.2] * len(values), "o", color=colour, alpha=0.4, markersize=5)
        ax.errorbar(mean, i - 0.08, xerr=half, fmt="D", color=colour, capsize=6, linewidth=2, markersize=7)
        told.append(f"{name}: {mean:.1f} ± {half:.1f}")
    name_rows(ax, list(earned))
    ax.set_ylim(len(earned) - 0.4, -0.5)
    figure.alt = f"Mean reward a step, {n} robots each. {'; '.join(told)}."
    return figure
