"""The worlds of the playground as data: all that simulation.js needs of them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from rlrobot_edu.models.model_env import SampleModelEnv
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.robots.arenas import arena_of
from rlrobot_edu.robots.cell_robot import BOX_MOVES, CELLS, CellRobot
from rlrobot_edu.robots.chassis import CHASSIS
from rlrobot_edu.robots.engines.kinematic.base import Body, walls_of
from rlrobot_edu.task.robot_cards import LASER_RANGE, LASERS
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.variables import Bin
from rlrobot_edu.widgets.playground.cliff import CLIFF, GOAL, MOVES, SHAPE, cliff_model

World = dict[str, Any]
WITHOUT_END = 0  # steps of an episode that is never cut off


def base_world(task: Task) -> World:
    """What `BaseWorld` needs of a task of the mobile base."""
    chassis, arena = CHASSIS[task.robot], arena_of(task.scene)
    body, (x, y, theta) = Body.of(chassis), arena.start
    twists, words = (
        [chassis.twist(command) for command in task.commands],
        _actions(task),
    )
    return _in_common(
        task.states.shape, task.actions.n, max(task.rewards), task.episode_steps
    ) | {
        "kind": "BaseWorld",
        "words": _words(task),
        "actions": [_motion(*twist) for twist in twists],
        "commands": words["actions"],
        "twists": twists,
        "inputs": [
            {"name": v.name, "cuts": v.cuts, "sectors": v.sectors} for v in task.inputs
        ],
        "start": [
            *chassis.axle_at(x, y, theta),
            theta,
        ],
        "bounds": arena.bounds,
        "goal": arena.goal,
        "goalSteps": task.goal_steps,
        "stepTime": task.step_time,
        "walls": walls_of(arena).tolist(),
        "hull": body.hull.tolist(),
        "outline": chassis.hull,
        "radius": body.radius,
        "moment": body.moment,
        "rays": body.rays.tolist(),
        "lasers": LASERS,
        "axle": chassis.axle,
        "inset": chassis.inset,
        "range": LASER_RANGE,
    }


def cliff_world() -> World:
    """What `ModelWorld` needs of the cliff of lesson 06."""
    rows, columns = SHAPE
    cells = [
        [column, rows - 1 - row] for row in range(rows) for column in range(columns)
    ]
    return model_world(
        cliff_model(), [{"cell": cell, "heading": None} for cell in cells], r_max=1.0
    ) | {
        "actions": MOVES,
        "arrows": [
            {"up": "↑", "right": "→", "down": "↓", "left": "←"}[move] for move in MOVES
        ],
        "words": [
            ["row", list("0123")],
            ["column", [str(column) for column in range(columns)]],
        ],
        "cliff": [cells[s] for s in CLIFF],
        "goal": cells[GOAL],
    }


def cells_world(task: Task) -> World:
    """What `CellWorld` needs of a task in the cells, such as the paper's worked example.

    Its places say where robot and box are, of which the robot sees less. Their table is found by putting the library's
    robot in each place and letting it act.
    """
    robot = CellRobot(task.scene, task.step_time)
    headings = (0, 90, -90)
    places = [
        (cell, heading, box)
        for cell in CELLS
        for heading in headings
        for box in CELLS
        if box != cell
    ]
    n_actions, moves = task.actions.n, round(1 / BOX_MOVES)
    offsets, s_next, r, cumulative = [0], [], [], []
    for place in places:
        for a in range(n_actions):
            outcomes = [
                _moved(robot, task, place, a, box) for box in (None, 0, 1)
            ]  # it stays, or goes to one of two
            for (after, reward), times in zip(
                outcomes, (2 * (moves - 1), 1, 1), strict=True
            ):
                s_next.append(places.index(after))
                r.append(reward)
                cumulative.append(
                    (cumulative[-1] if len(s_next) > offsets[-1] + 1 else 0) + times
                )
            offsets.append(len(s_next))
    model = SampleModel(
        shape=(len(places),), n_actions=n_actions, offsets=np.array(offsets), s_next=np.array(s_next),
        r=np.array(r), terminated=np.zeros(len(r), dtype=bool), cumulative=np.array(cumulative),
        starts=np.array([places.index(((0, 0), 0, (1, 1)))]), rewards=np.array(sorted(set(r))),
        episode_steps=task.episode_steps,
    )  # fmt: skip
    drawn = [
        {"cell": cell, "heading": heading, "box": box} for cell, heading, box in places
    ]
    seen = [_seen(robot, task, place) for place in places]
    told = {
        "kind": "CellWorld",
        "boxMoves": BOX_MOVES,
        "shape": task.states.shape,
        "seen": seen,
    }
    told |= {"words": _words(task), "actions": _actions(task)["actions"]}
    return model_world(model, drawn, r_max=max(task.rewards)) | told


def model_world(
    model: SampleModel, drawn: Sequence[Mapping[str, Any]], r_max: float
) -> World:
    """What `ModelWorld` needs of a sample model in which each place is a state; drawn: how each is drawn."""
    tables = SampleModelEnv(model)._tables._asdict()
    return _in_common(model.shape, model.n_actions, r_max, model.episode_steps) | {
        "kind": "ModelWorld",
        "tables": {name: np.asarray(value).tolist() for name, value in tables.items()},
        "seen": list(range(model.n_states)),
        "drawn": list(drawn),
    }


def _in_common(
    shape: Sequence[int], n_actions: int, r_max: float, episode_steps: int | None
) -> World:
    return {
        "shape": list(shape), "nActions": n_actions, "rMax": r_max, "episodeSteps": episode_steps or WITHOUT_END,
    }  # fmt: skip


def _words(task: Task) -> list[Any]:
    """Name of each input, and its bins in words."""
    return [
        [_plain(v.name), [_in_words(v.decode(i)) for i in range(v.n_bins)]]
        for v in task.inputs
    ]


def _in_words(one: Bin) -> str:
    if math.isinf(one.low):
        return _plain(f"up to {one.high:g} {one.unit}")
    return _plain(f"above {one.low:g} {one.unit}" if math.isinf(one.high) else str(one))


def _actions(task: Task) -> World:
    """The actions in words, without the names of the outputs, which are above them."""
    words = task.actions.labels
    for v in task.outputs:
        words = [label.replace(f"{v.name} ", "") for label in words]
    units = ", ".join(dict.fromkeys(v.unit for v in task.outputs if v.unit))
    called = ", ".join(v.name for v in task.outputs) + (f" [{units}]" if units else "")
    return {
        "actions": [_plain(label) for label in words],
        "actionsCalled": _plain(called),
    }


def _motion(v: float, omega: float) -> str:
    """What a robot does at v [m/s] and omega [rad/s], in words: a task may command other speeds than an action's."""
    if omega == 0:
        return f"ahead, {v:.1f} m/s" if v else "stand still"
    return f"{'arc' if v else 'spin'} {'left' if omega > 0 else 'right'}"


def _plain(text: str) -> str:
    """A text as it is written in print."""
    return text.replace("_", " ").replace("-", "−")


class _Luck:
    """Random numbers that move the box of a CellRobot to the free cell of this number, or not at all with None."""

    def __init__(self, box: int | None) -> None:
        self.box = box

    def random(self) -> float:
        return 1.0 if self.box is None else 0.0

    def integers(self, n: int) -> int:
        assert self.box is not None and n == 2
        return self.box


def _put(robot: CellRobot, place: Any) -> None:
    vars(robot).update(
        zip(("_cell", "_heading", "_box", "_bumped"), (*place, False), strict=True)
    )


def _seen(robot: CellRobot, task: Task, place: Any) -> int:
    _put(robot, place)
    return task.states.encode(robot._sense())


def _moved(
    robot: CellRobot, task: Task, place: Any, a: int, box: int | None
) -> tuple[Any, float]:
    """Where an action leads, and its reward, if the box moves so."""
    _put(robot, place)
    before = robot._sense()
    vars(robot)["_rng"] = _Luck(box)
    robot._move(task.command_for(a))
    return (robot._cell, robot._heading, robot._box), task.reward_for(
        before, robot._sense()
    )
