"""The loop of learning as one kernel, for an environment whose world consists of kernels: a sample model or a robot."""

from collections.abc import Callable, Iterator
from functools import cache
from typing import Any, cast

import numpy as np

from rlrobot_edu.jit.building import build
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.kernel_world import KernelEnv, KernelWorld
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.learning.own_code import Before
from rlrobot_edu.learning.planning.experience import with_room
from rlrobot_edu.learning.resume import ResumePoint, place_of
from rlrobot_edu.learning.size import Env
from rlrobot_edu.learning.step import make_step, own_parts
from rlrobot_edu.learning.templates import loop
from rlrobot_edu.learning.transitions import Transitions

# Compiled steps, imagined ones too, after which Ctrl-C is heard; about 0.1 s
SLICE = 50_000


@cache
def make_run(
    method: Method, begin: Callable[..., Any], outcome: Callable[..., Any]
) -> Callable[..., Any]:
    """The whole loop of learning in a world of these kernels, see templates/loop.py."""
    step = make_step(method)
    built = build(
        loop,
        begin=begin,
        outcome=outcome,
        select=step.select,
        learn_step=step.learn_step,
        planned_step=step.planned_step,
    )
    return cast(Callable[..., Any], built.run)


def run_slices(
    env: KernelEnv,
    world: KernelWorld,
    agent: Agent,
    log: Transitions,
    episodes: int | None,
) -> Iterator[int]:
    """Fill `log`, in slices, and yield the number of steps of each. It ends sooner if the world cannot compute a step.

    After each slice, `agent` can go on from there, and `env` has taken over the state.
    """
    run = make_run(agent.method, world.begin, world.outcome)
    s, a = agent.pending or (0, -1)
    at = np.array([s, a, env.episode_step, 0, episodes or 0])
    size = SLICE
    if agent.method.planner:
        size = SLICE // (1 + agent.parameters.planning_steps) + 1
    for first in range(0, len(log.r), size):
        part = log.part(slice(first, first + size))
        left = agent.resume_point or ResumePoint()
        agent.experience = agent.experience and with_room(agent.experience, len(part.r))
        agent.resume_point = None
        at[3] = 0
        try:
            _run(run, env, world, agent, at, part)
        finally:  # Ctrl-C, pressed while the kernel runs, is raised when it has returned
            s, a, env.episode_step, n, episodes_left = at.tolist()
            env.arrive(s)
            agent.pending = None if a < 0 else (s, a)
            earlier = left.reward if env.episode_step > n else 0.0
            first_of_episode = max(n - env.episode_step, 0)
            rewards = np.append(earlier, part.r[first_of_episode:n])
            total = float(rewards.cumsum()[-1])
            place = place_of(cast(Env, env))
            agent.resume_point = ResumePoint(env.episode_step, total, place)
        yield n
        if n < len(part.r) or (episodes and not episodes_left):
            return


def _run(
    run: Callable[..., Any],
    env: KernelEnv,
    world: KernelWorld,
    agent: Agent,
    at: np.ndarray,
    log: Transitions,
) -> None:
    """Run the loop. If a kernel of the user's own fails, everything is restored as it was before that step.

    Then the plain loop takes that step, and its error names the mistake.
    """
    learner = (agent.memory, agent.experience)
    given = (world.arrays, *learner, env.np_random, agent.rng, at)
    if not own_parts(agent.method):
        run(*given, log)
        return
    before = Before()
    before.take(agent.memory, agent.experience, agent.rng)
    place = [array.copy() for array in (*world.state, at)]
    world_rng = env.np_random.bit_generator.state
    try:
        run(*given, log)
    except Exception:
        n = at[3]
        before.put_back()
        env.np_random.bit_generator.state = world_rng
        for array, old in zip((*world.state, at), place, strict=True):
            array[...] = old
        if n > 0:  # the whole steps before it once more
            run(*given, log.part(slice(n)))
