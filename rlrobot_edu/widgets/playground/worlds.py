"""The worlds of the playground as data, for simulation.js."""

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
from rlrobot_edu.widgets.motions import name_of
from rlrobot_edu.widgets.playground.cliff import CLIFF, GOAL, MOVES, SHAPE, cliff_model

World = dict[str, Any]
Cell = tuple[int, int]
Place = tuple[Cell, int, Cell]  # cell and heading [deg] of the robot, cell of the box

WITHOUT_END = 0  # steps of an episode that is never cut off
HEADINGS = (0, 90, -90)  # [deg]
ARROWS = {"up": "↑", "right": "→", "down": "↓", "left": "←"}


def base_world(task: Task) -> World:
    """What `BaseWorld` needs of a task of the mobile base."""
    chassis = CHASSIS[task.robot]
    arena = arena_of(task.scene)
    body = Body.of(chassis)
    x, y, theta = arena.start
    axle_x, axle_y = chassis.axle_at(x, y, theta)
    twists = [chassis.twist(command) for command in task.commands]
    motions = [name_of(v, omega) for v, omega in twists]
    inputs = []
    for variable in task.inputs:
        cuts, sectors = variable.cuts, variable.sectors
        inputs.append({"name": variable.name, "cuts": cuts, "sectors": sectors})
    return _of_all_worlds(
        task.states.shape, task.actions.n, max(task.rewards), task.episode_steps
    ) | {
        "kind": "BaseWorld",
        "words": _words(task),
        "actions": motions,
        "commands": _actions(task)["actions"],
        "twists": twists,
        "inputs": inputs,
        "start": [axle_x, axle_y, theta],
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
    cells = []
    for row in range(rows):
        for column in range(columns):
            cells.append([column, rows - 1 - row])
    drawn = [{"cell": cell, "heading": None} for cell in cells]
    return model_world(cliff_model(), drawn, r_max=1.0) | {
        "actions": MOVES,
        "arrows": [ARROWS[move] for move in MOVES],
        "words": [
            ["row", [str(row) for row in range(rows)]],
            ["column", [str(column) for column in range(columns)]],
        ],
        "cliff": [cells[s] for s in CLIFF],
        "goal": cells[GOAL],
    }


def cells_world(task: Task) -> World:
    """What `CellWorld` needs of a task in the cells, such as the paper's worked example.

    A place is where robot and box are; the robot senses less than that. The table of outcomes is found by putting the
    library's robot in each place and letting it act.
    """
    robot = CellRobot(task.scene, task.step_time)
    places = _places()
    model = _model_of(robot, task, places)
    drawn = []
    for cell, heading, box in places:
        drawn.append({"cell": cell, "heading": heading, "box": box})
    return model_world(model, drawn, r_max=max(task.rewards)) | {
        "kind": "CellWorld",
        "boxMoves": BOX_MOVES,
        "shape": task.states.shape,
        "seen": [_seen(robot, task, place) for place in places],
        "words": _words(task),
        "actions": _actions(task)["actions"],
    }


def _places() -> list[Place]:
    places = []
    for cell in CELLS:
        for heading in HEADINGS:
            for box in CELLS:
                if box != cell:
                    places.append((cell, heading, box))
    return places


def _model_of(robot: CellRobot, task: Task, places: list[Place]) -> SampleModel:
    """The outcomes of each action in each place: the box stays, or moves to one of the two free cells."""
    n_moves = round(1 / BOX_MOVES)  # steps in which the box moves once
    times = (2 * (n_moves - 1), 1, 1)  # of 2 · n_moves steps
    cumulative_times = np.cumsum(times).tolist()
    offsets = [0]
    s_next: list[int] = []
    r: list[float] = []
    cumulative: list[int] = []
    for place in places:
        for a in range(task.actions.n):
            for box in (None, 0, 1):
                after, reward = _moved(robot, task, place, a, box)
                s_next.append(places.index(after))
                r.append(reward)
            cumulative += cumulative_times
            offsets.append(len(s_next))
    start = places.index(((0, 0), 0, (1, 1)))
    return SampleModel(
        shape=(len(places),),
        n_actions=task.actions.n,
        offsets=np.array(offsets),
        s_next=np.array(s_next),
        r=np.array(r),
        terminated=np.zeros(len(r), dtype=bool),
        cumulative=np.array(cumulative),
        starts=np.array([start]),
        rewards=np.array(sorted(set(r))),
        episode_steps=task.episode_steps,
    )


def model_world(
    model: SampleModel, drawn: Sequence[Mapping[str, Any]], r_max: float
) -> World:
    """What `ModelWorld` needs of a sample model in which each place is a state; drawn: how each is drawn."""
    tables = SampleModelEnv(model)._tables._asdict()
    return _of_all_worlds(model.shape, model.n_actions, r_max, model.episode_steps) | {
        "kind": "ModelWorld",
        "tables": {name: np.asarray(value).tolist() for name, value in tables.items()},
        "seen": list(range(model.n_states)),
        "drawn": list(drawn),
    }


def _of_all_worlds(
    shape: Sequence[int], n_actions: int, r_max: float, episode_steps: int | None
) -> World:
    """What all worlds need."""
    return {
        "shape": list(shape),
        "nActions": n_actions,
        "rMax": r_max,
        "episodeSteps": episode_steps or WITHOUT_END,
    }


def _words(task: Task) -> list[Any]:
    """Name of each input, and its bins in words."""
    words = []
    for variable in task.inputs:
        bins = [_in_words(variable.decode(i)) for i in range(variable.n_bins)]
        words.append([_plain(variable.name), bins])
    return words


def _in_words(one: Bin) -> str:
    if math.isinf(one.low):
        text = f"up to {one.high:g} {one.unit}"
    elif math.isinf(one.high):
        text = f"above {one.low:g} {one.unit}"
    elif one.low < one.high:
        text = f"{one.low:.3g}–{one.high:.3g} {one.unit}"
    else:
        text = str(one)
    return _plain(text)


def _actions(task: Task) -> World:
    """The actions in words, without the names of the outputs, which stand above them."""
    words = task.actions.labels
    for variable in task.outputs:
        words = [label.replace(f"{variable.name} ", "") for label in words]
    called = ", ".join(variable.name for variable in task.outputs)
    units = dict.fromkeys(variable.unit for variable in task.outputs if variable.unit)
    if units:
        called += f" [{', '.join(units)}]"
    return {
        "actions": [_plain(label) for label in words],
        "actionsCalled": _plain(called),
    }


def _plain(text: str) -> str:
    """A text with spaces and true minus signs, as in print."""
    return text.replace("_", " ").replace("-", "−")


class _Luck:
    """Random numbers that move the box of a CellRobot to the free cell of this number; with None, the box stays."""

    def __init__(self, box: int | None) -> None:
        self.box = box

    def random(self) -> float:
        return 1.0 if self.box is None else 0.0

    def integers(self, n: int) -> int:
        assert self.box is not None and n == 2
        return self.box


def _put(robot: CellRobot, place: Place) -> None:
    robot._cell, robot._heading, robot._box = place
    robot._bumped = False


def _seen(robot: CellRobot, task: Task, place: Place) -> int:
    """The state that the robot observes in a place."""
    _put(robot, place)
    return task.states.encode(robot._sense())


def _moved(
    robot: CellRobot, task: Task, place: Place, a: int, box: int | None
) -> tuple[Place, float]:
    """The place to which an action leads, and its reward, if the box moves so."""
    _put(robot, place)
    before = robot._sense()
    robot._rng = _Luck(box)  # type: ignore[assignment]
    robot._move(task.command_for(a))
    after = (robot._cell, robot._heading, robot._box)
    return after, task.reward_for(before, robot._sense())
