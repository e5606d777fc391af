"""A robot and its scene from above, as SVG for the browser and on matplotlib axes for the still picture."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_edu.course.stepper.cell_values import Mark
from rlrobot_edu.course.stepper.colours import largest, tint
from rlrobot_edu.course.stepper.numerals import short
from rlrobot_edu.course.stepper.tape import PATH, Tape
from rlrobot_edu.robots.scene import Scene, Solid
from rlrobot_edu.show.palette import GREY, ROLE
from rlrobot_edu.show.scenes import describe, path_of
from rlrobot_edu.show.top_down import TopDown, footprint, nose

WIDE, HIGH = 0.36, 0.25  # of a mark [m]; two lines of small letters fit into it
SHORT = 0.6  # of the line that says where the robot looks: among marks it ends before the one ahead
_CELL_LINES = '<path class="lines" d="M0,-1V1M-1,0H1"/>'  # between the four cells of the worked example
_ORDER = ("goal", "object", "robot", "wheel")  # from below to the top


class RobotView:
    """Pictures of what `robot` does; the walls are drawn once.

    marks: function (tape, scene) -> what the agent thinks of places in the scene, if it can be drawn there
    """

    wide = False

    def __init__(self, robot: Any, marks: Callable[[Tape, Scene], list[Mark]] | None) -> None:
        self.heading = "From above, and the value of each heading" if marks else "The world from above"
        self._robot, self._marks = robot, marks or (lambda tape, scene: [])
        self._walls: tuple[Solid, ...] = ()

    def look(self, s: int) -> Scene:
        """The scene without its walls, which do not move."""
        scene = self._robot.scene()
        if not self._walls:
            self._walls = tuple(solid for solid in scene.solids if solid.role == "wall")
            self._background = "".join(map(_polygon, self._walls))
        return scene._replace(solids=tuple(solid for solid in scene.solids if solid.role != "wall"))

    def html(self, tape: Tape) -> str:
        """The last scene and the path to it."""
        looks = tape.looks()
        scene, path = looks[-1], path_of(looks)
        x_min, y_min, x_max, y_max = scene.bounds
        margin = 0.03 * max(x_max - x_min, y_max - y_min)
        width, height = x_max - x_min + 2 * margin, y_max - y_min + 2 * margin
        beams = "".join(
            f'<line x1="{x1:.3f}" y1="{y1:.3f}" x2="{x2:.3f}" y2="{y2:.3f}"/>'
            for (x1, y1), (x2, y2) in scene.beams[:, :, :2].tolist()
        )
        most = largest(tape.q, tape.agent.parameters.r_max)
        marks = "".join(_chip(mark, most) for mark in self._marks(tape, scene))
        lines = _CELL_LINES if marks else ""
        moving = sorted(scene.solids, key=lambda solid: _ORDER.index(solid.role))
        # y grows upwards in the scene and downwards in SVG
        return (
            f'<svg viewBox="{x_min - margin:.3f} {-y_max - margin:.3f} {width:.3f} {height:.3f}" role="img" '
            f'aria-label="{describe(scene)}"><g transform="scale(1,-1)">{self._background}{lines}'
            f'<polyline class="path" points="{_points(path[:, :2])}"/><g class="beams">{beams}</g>'
            f"{''.join(map(_polygon, moving))}{_heading(scene, SHORT if marks else 1)}</g>{marks}</svg>"
        )

    def draw(self, ax: Axes, tape: Tape) -> None:
        """The same on matplotlib's axes, without its numbers: they would take the room of the marks."""
        looks, most = tape.looks(), largest(tape.q, tape.agent.parameters.r_max)
        scene = looks[-1]._replace(solids=self._walls + looks[-1].solids)
        view = TopDown(ax, scene)
        view.update(scene, path_of(looks))
        marks = self._marks(tape, scene)
        if marks or len(looks) >= PATH:  # there is no room, or the trail no longer reaches back to the start
            view.words["start"].set_text("")
        ax.set_axis_off()
        if marks:
            for draw_line in (ax.axvline, ax.axhline):  # between the cells
                draw_line(0, color=GREY, linewidth=0.8, alpha=0.5, zorder=0)
            ahead = view.heading.get_xydata()
            view.heading.set_data(*(ahead[0] + SHORT * (ahead - ahead[0])).T)
        for mark in marks:
            colour, opacity = tint(mark.value, most)
            for ink, alpha in (("white", 1), (colour, opacity)):
                corner = mark.x - WIDE / 2, mark.y - HIGH / 2
                ax.add_patch(Rectangle(corner, WIDE, HIGH, color=ink, alpha=alpha, linewidth=0, zorder=20))
            ax.text(mark.x, mark.y, f"{mark.icons}\n{short(mark.value)}", ha="center", va="center", fontsize=8.5,
                    linespacing=0.9, zorder=21)  # fmt: skip


def _points(xy: np.ndarray) -> str:
    return " ".join(f"{x:.3f},{y:.3f}" for x, y in xy.tolist())


def _polygon(solid: Solid) -> str:
    faint = ' fill-opacity="0.45"' if solid.role == "goal" else ""
    return f'<polygon fill="{ROLE[solid.role]}"{faint} points="{_points(footprint(solid))}"/>'


def _heading(scene: Scene, length: float) -> str:
    """A line from the middle of the robot to its front, or only a part of the way."""
    for solid in scene.solids:
        if solid.name == "robot/body":
            (x1, y1), (x2, y2) = nose(solid)
            x2, y2 = x1 + length * (x2 - x1), y1 + length * (y2 - y1)
            return f'<line class="heading" x1="{x1:.3f}" y1="{y1:.3f}" x2="{x2:.3f}" y2="{y2:.3f}"/>'
    return ""


def _chip(mark: Mark, most: float) -> str:
    """A mark: its icons above its value, on the colour of the value."""
    colour, opacity = tint(mark.value, most)
    box = f'x="{mark.x - WIDE / 2:.3f}" y="{-mark.y - HIGH / 2:.3f}" width="{WIDE}" height="{HIGH}"'
    return (
        f'<g class="chip"><title>state {mark.state}: {mark.icons} {short(mark.value)}</title><rect {box} fill="#fff"/>'
        f'<rect {box} fill="{colour}" fill-opacity="{opacity}"/><text x="{mark.x:.2f}" y="{-mark.y - 0.01:.2f}">'
        f'{mark.icons}</text><text x="{mark.x:.2f}" y="{-mark.y + 0.08:.2f}">{short(mark.value)}</text></g>'
    )
