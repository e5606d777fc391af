"""Cells with walls between start and goal, without chance: smaller than Sutton & Barto's example 8.1, and like it."""

from copy import deepcopy
from typing import Any

import gymnasium
import numpy as np
from gymnasium.spaces import Discrete, MultiDiscrete

from rlrobot_edu import Agent, learn
from rlrobot_edu import steps as walk
from rlrobot_edu.learning.algorithm import Planner
from rlrobot_edu.learning.history import History
from rlrobot_edu.learning.loop import Step

MAP = ["....#.G", "S##.#..", "..#....", "..###..", "....#.."]
SHAPE = len(MAP), len(MAP[0])  # rows, from the top, and columns
START, GOAL = (1, 0), (0, 6)
WALLS = frozenset(cell for cell in np.ndindex(SHAPE) if MAP[cell[0]][cell[1]] == "#")
MOVES = ((-1, 0), (0, 1), (1, 0), (0, -1))  # actions 0 to 3: up, right, down, left
SHORTEST = 11  # moves from start to goal


def number(cell: tuple[int, int]) -> int:
    """The number of a cell's state; rows count slowest."""
    return cell[0] * SHAPE[1] + cell[1]


def neighbour(cell: tuple[int, int], a: int) -> tuple[int, int]:
    """Where action `a` leads: to the next cell, or nowhere if a wall or the edge is in the way."""
    row, column = cell[0] + MOVES[a][0], cell[1] + MOVES[a][1]
    inside = 0 <= row < SHAPE[0] and 0 <= column < SHAPE[1]
    return (row, column) if inside and (row, column) not in WALLS else cell


class Cells(gymnasium.Env[np.ndarray, np.int64]):
    """A robot in cells. It moves up, right, down or left by one; a step to the goal pays 1 and ends the episode.

    Any other step pays 0. In front of a wall the robot stays where it is.
    """

    def __init__(self) -> None:
        self.observation_space = MultiDiscrete(SHAPE)  # type: ignore[assignment]  # Gymnasium types it as its own
        self.action_space = Discrete(len(MOVES))
        self.cell = START

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[np.ndarray, dict]:
        """Put the robot on the start."""
        super().reset(seed=seed)
        self.cell = START
        return np.array(self.cell), {}

    def step(self, action: np.int64) -> tuple[np.ndarray, float, bool, bool, dict]:
        """Move by one cell, if nothing is in the way."""
        self.cell = neighbour(self.cell, int(action))
        at_goal = self.cell == GOAL
        return np.array(self.cell), float(at_goal), at_goal, False, {}


def best_way(q: np.ndarray) -> list[tuple[int, int]]:
    """The cells from the start on of a robot that always takes its best action.

    q: array (35, 4). The way ends at the goal, where it comes back to a cell, or where nothing is known yet.
    """
    way = [START]
    while way[-1] != GOAL and len(set(way)) == len(way):
        row = q[number(way[-1])]
        if not row.any():
            break
        way.append(neighbour(way[-1], int(row.argmax())))
    return way


def steps_needed(seed: int, most: int = 20_000, **planner: Any) -> tuple[int, int]:
    """Real steps of an agent until its first arrival at the goal, and until its best way is the shortest.

    planner: parameters of the agent; it learns with Q-learning and ε-greedy
    """
    env, arrived = Cells(), 0
    agent = Agent(env, "Q+EG", seed=seed, **planner)
    for step in walk(agent, env, most):
        arrived = arrived or (step.t + 1) * step.terminated
        if not arrived:
            continue
        way = best_way(agent.q)
        if len(way) - 1 == SHORTEST and way[-1] == GOAL:
            return arrived, step.t + 1
    return arrived or most, most


def again(seed: int) -> dict[str, History]:
    """A robot after its first arrival at the goal, and the same one that now thinks 50 thoughts a step: 1000 steps."""
    robot = Agent(Cells(), "Q+EG", planner="dyna", planning_steps=0, seed=seed)
    learn(robot, Cells(), 20_000, episodes=1, progress=False)
    thinker = deepcopy(robot)
    thinker.change(planning_steps=50)
    agents = {"learns once from a step": robot, "thinks between its steps": thinker}
    return {
        name: learn(agent, Cells(), 1000, keep=True, progress=False)
        for name, agent in agents.items()
    }


def first_episode(seed: int) -> list[Step]:
    """The steps of a robot that knows nothing, up to its first arrival at the goal."""
    env, episode = Cells(), []
    for step in walk(Agent(env, "Q+EG", seed=seed), env, 20_000):
        episode.append(step)
        if step.terminated:
            break
    return episode


def thoughts(episode: list[Step], planner: str | Planner, n: int) -> np.ndarray:
    """The number of the thought, up to n, by which a state got its first value after this episode, array (35,) of int.

    0: the last step itself; -1: none of them. Before the goal all values are 0, and no thought can change that.
    """
    first = np.full(SHAPE[0] * SHAPE[1], -1)
    for i in range(n + 1):
        agent = Agent(Cells(), "Q+EG", planner=planner, planning_steps=0, seed=0)
        for step in episode:
            agent.change(planning_steps=i * step.terminated)
            agent.update(
                step.s, step.a, step.r, step.s_next, step.a_next or 0, step.terminated
            )
        first[(agent.q.max(axis=1) > 0) & (first < 0)] = i
    return first
