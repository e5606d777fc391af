"""Seconds of a step in MushroomRL and in plain NumPy, as JSON, on a sample model as npz: for bench.py."""

import io
import json
import sys
import time
from pathlib import Path
from types import SimpleNamespace
from unittest.mock import MagicMock

import numpy as np

# MushroomRL imports these (PyTorch alone takes gigabytes), but calls none of them when it learns a table
UNUSED = """cv2 pygame scipy scipy.integrate scipy.optimize scipy.spatial.transform scipy.special scipy.stats
    sklearn.exceptions sklearn.utils.extmath torch torch.nn torch.nn.functional torch.nn.parameter torch.optim"""
sys.modules.update((name, MagicMock()) for name in UNUSED.split())
ROOT = Path(__file__).parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "tests")]
from mushroom_rl import __version__  # noqa: E402
from mushroom_rl.algorithms.value import QLearning, SARSALambda  # noqa: E402
from mushroom_rl.core import Core, Environment, MDPInfo  # noqa: E402
from mushroom_rl.policy import Boltzmann  # noqa: E402
from mushroom_rl.utils.parameters import Parameter  # noqa: E402
from mushroom_rl.utils.spaces import Discrete  # noqa: E402
from oracles import NumpyModelWorld, numpy_q_learning  # noqa: E402

STEPS, ALPHA, GAMMA, LAMBDA = (
    3600,
    0.1,
    0.9,
    0.9,
)  # and a temperature of 1, as the toolkit's defaults are


class MushroomWorld(Environment):
    """The world of the plain loop, as MushroomRL asks for it."""

    def __init__(self, world):
        super().__init__(
            MDPInfo(
                Discrete(world.model.n_states),
                Discrete(world.model.n_actions),
                GAMMA,
                np.inf,
            )
        )
        self.world = world

    def reset(self, state=None):
        return np.array([self.world.reset()])

    def step(self, action):
        s, r = self.world.step(action[0])
        return np.array([s]), r, False, {}


def mushroom(world, algorithm, *parameters):
    env = MushroomWorld(world)
    agent = algorithm(
        env.info,
        Boltzmann(100 * (1 - GAMMA) / world.model.r_max),
        Parameter(ALPHA),
        *parameters,
    )
    Core(agent, env).learn(n_steps=STEPS, n_steps_per_fit=1, quiet=True)


def seconds_a_step(learn, *arguments):
    start = time.perf_counter()
    learn(NumpyModelWorld(model, np.random.default_rng(11)), *arguments)
    return (time.perf_counter() - start) / STEPS


facts = np.load(io.BytesIO(sys.stdin.buffer.read()))
model = SimpleNamespace(
    **{name: part if part.ndim else part.item() for name, part in facts.items()}
)
who = f"MushroomRL {__version__}"
plain = seconds_a_step(numpy_q_learning, STEPS, np.random.default_rng(7), ALPHA, GAMMA)
q, sarsa = (
    seconds_a_step(mushroom, QLearning),
    seconds_a_step(mushroom, SARSALambda, LAMBDA),
)
print(json.dumps({"Q+SR": {who: q, "plain NumPy": plain}, "SL+SR": {who: sarsa}}))
