"""What the exercises of lesson 10 share."""

import copy
from collections.abc import Callable
from types import FunctionType
from typing import Any

import numpy as np

from rlrobot_course.lesson_04.exercises import draw, softmax
from rlrobot_course.lesson_10.worlds import Dice, Ring, SharpDice
from rlrobot_course.worlds.tapes import RobotWorld, beside
from rlrobot_edu import Agent
from rlrobot_edu import learn as run
from rlrobot_edu.learning.size import Size

SHAPE, OTHER = (2, 2, 3, 2), (3, 4)
FINE = np.random.default_rng(6).normal(3.0, 6.0, size=(24, 3))  # with many digits
Q = np.random.default_rng(9).normal(3.0, 6.0, size=(24, 3)).round(1)
P = np.random.default_rng(4).normal(-1.0, 5.0, size=(12, 4)).round(1)

Ends = tuple[
    tuple[int, bool], ...
]  # of episodes: after how many steps, and whether they terminate
ENDS: Ends = ((5, True), (4, False), (6, False), (3, True))
USUAL = {"alpha": 0.1, "gamma": 0.9, "lam": 0.9}
FINELY = {"alpha": 0.21234, "gamma": 0.87654, "lam": 0.65432, "r_max": 3.45678}
OTHERS = {"alpha": 0.3, "gamma": 0.8, "lam": 0.6, "n_actions": 4, "r_max": 2.0}


def library(
    right: Callable[..., np.ndarray],
    env: RobotWorld | Ring,
    shape: tuple[int, ...],
    n_actions: int,
    r_max: float,
    steps: int,
    rng: Any,
    alpha: float,
    gamma: float,
    lam: float,
    temperature: float,
    loop_evasion: bool = False,
) -> np.ndarray:
    """The library's agent in the learner's world: what a right answer equals, number for number.

    right: the right answer, which is itself the measure in worlds that are none of the library's
    """
    if isinstance(env, Ring):
        return right(
            env, shape, n_actions, r_max, steps, rng, alpha, gamma, lam, temperature
        )
    about = {
        "alpha": alpha,
        "gamma": gamma,
        "lam": lam,
        "temperature": temperature,
        "traces": "full",
    }
    agent = Agent(
        Size(shape, n_actions, r_max),
        "TOSL+QBIASSR",
        loop_evasion=loop_evasion,
        **about,
    )
    agent.rng = rng
    run(agent, env.env, steps, progress=False)
    return agent.q


def drives(rings: list[dict[str, Any]], temperature: str) -> list[dict[str, Any]]:
    """The first ring, the robot of the worked example, the other rings. temperature: what this argument is called."""
    robot = RobotWorld("worked_example", seed=0)
    about = {
        "env": robot,
        "shape": robot.shape,
        "n_actions": robot.n_actions,
        "r_max": robot.r_max,
    }
    robots = [
        {
            **about,
            "steps": n,
            "rng": np.random.default_rng(seed),
            **USUAL,
            temperature: 1.0,
        }
        for n, seed in ((1, 0), (5, 1), (45, 2))
    ]
    return [rings[0], *robots, *rings[1:]]


def ring(
    shape: tuple[int, ...],
    ends: Ends,
    n: int,
    sticky: int = 1,
    pays: tuple[float, ...] = (),
    **rest: float,
) -> dict[str, Any]:
    """The arguments of a learner that is let loose in a ring for n steps, with 3 actions and an r_max of 6 if not told.

    rest: the other arguments, by name
    """
    about = {"n_actions": 3, "r_max": 6.0, **rest}
    world = Ring(int(np.prod(shape)), ends, sticky, about["r_max"], pays)
    return {"env": world, "shape": shape, "steps": n, "rng": Dice(world), **about}


def sharp(
    right: FunctionType,
    preferences: Callable[..., np.ndarray],
    case: dict[str, Any],
) -> dict[str, Any]:
    """`case`, a ring, with random numbers beside the borders between the actions of the right learner.

    preferences: of the actions, as the right learner's choice asks for them
    """
    world = copy.deepcopy(case["env"])
    dice = Dice(world)
    numbers: dict[tuple[int, int], float] = {}

    def choose(
        q: np.ndarray,
        shape: tuple[int, ...],
        s: int,
        temperature: float,
        r_max: float,
        gamma: float,
        u: float,
    ) -> int:
        p = softmax(preferences(q, shape, s, r_max, gamma), temperature)
        number = beside(p, u, len(numbers) % 2 == 0)
        numbers[dice.moment()] = number
        return int(draw(p, number))

    learner = FunctionType(right.__code__, right.__globals__ | {"choose": choose})
    learner(**{**case, "env": world, "rng": dice})
    return {**case, "rng": SharpDice(case["env"], numbers)}
