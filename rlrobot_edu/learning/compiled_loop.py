"""The loop of learning as one kernel, for an environment whose world is kernels, too: a sample model or a robot."""

from collections.abc import Callable, Iterator
from functools import cache
from typing import Any

import numpy as np

from rlrobot_edu.jit.dispatcher import borrowed, compiled
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.learning.planning.experience import with_room
from rlrobot_edu.learning.planning.planned_step import make_planned_step
from rlrobot_edu.learning.resume import ResumePoint, place_of
from rlrobot_edu.learning.step import begin_episode, make_step
from rlrobot_edu.learning.transitions import Transitions

SLICE = 50_000  # compiled steps, imagined ones too, between two looks at the keyboard; about 0.1 s
NEVER = 2**53  # steps after which an episode is cut off


@cache
def make_run(
    method: Method, begin: Callable[..., Any], outcome: Callable[..., Any]
) -> Callable[..., Any]:
    """The whole loop of learning in a world, compiled for this method and this kind of world alone.

    begin: (world, rng) -> state in which an episode begins
    outcome: (world, s, a, rng) -> (s', r, terminated)
    A state below 0: the world cannot tell, and is as if it had not been asked.
    """
    select, learn_step = make_step(method)[1:]
    planned_step = make_planned_step(method) if method.planner else None

    @compiled
    def run(world, m, x, world_rng, agent_rng, at, log):
        """Let the agent with memory `m` learn until the log is full, or until there are no episodes left.

        `x` is its experience, None without a planner.

        `at` holds (s, a, episode_step, steps, episodes): where to go on, a < 0 for a new episode; the steps
        done; and the episodes left, where 0 is no limit.
        The same loop, step for step and draw for draw, as `learning.loop.steps` over the world's environment. It ends
        sooner where the world cannot tell.
        """
        world, m, log = borrowed(world), borrowed(m), borrowed(log)
        limit, s, a, episode_step = world.episode_steps, at[0], at[1], at[2]
        for t in range(log.r.shape[0]):
            if a < 0:
                s = begin(world, world_rng)
                if s < 0:
                    return
                begin_episode(m)
                a = select(m, s, agent_rng.random())
                episode_step = 0
                at[0], at[1], at[2] = s, a, episode_step
            s_next, r, end = outcome(world, s, a, world_rng)
            if s_next < 0:
                return
            if planned_step is None:
                a_next, _ = learn_step(m, s, a, r, s_next, end, agent_rng.random())
            else:
                a_next, _ = planned_step(
                    m, x, s, a, r, s_next, end, agent_rng.random(), agent_rng
                )
            episode_step += 1
            cut = episode_step >= limit and not end
            log.s[t] = s
            log.a[t] = a
            log.r[t] = r
            log.s_next[t] = s_next
            log.terminated[t] = end
            log.truncated[t] = cut
            s, a = s_next, a_next
            if cut:
                a = -1
            at[0], at[1], at[2], at[3] = s, a, episode_step, t + 1
            if end or cut:
                at[4] -= 1
                if at[4] == 0:
                    return

    return run


def run_slices(
    env: Any,
    run: Callable[..., Any],
    world: Any,
    agent: Agent,
    log: Transitions,
    episodes: int | None,
) -> Iterator[int]:
    """Let `run` fill `log`, in slices: each yields its number of steps. It ends sooner where the world cannot tell.

    After each, `agent` is where it can go on, and the method ``arrive`` of `env` has been given the state there.
    """
    at = np.array([*(agent.pending or (0, -1)), env.episode_step, 0, episodes or 0])
    size = (
        SLICE // (1 + agent.parameters.planning_steps) + 1
        if agent.method.planner
        else SLICE
    )
    for first in range(0, len(log.r), size):
        part = log.part(slice(first, first + size))
        left = agent.resume_point or ResumePoint()
        agent.experience = x = agent.experience and with_room(
            agent.experience, len(part.r)
        )
        agent.resume_point = None
        at[3] = 0
        try:
            run(world, agent.memory, x, env.np_random, agent.rng, at, part)
        finally:  # Ctrl-C, pressed while the kernel runs, is raised when it has returned
            s, a, env.episode_step, n, episodes_left = at.tolist()
            env.arrive(s)
            agent.pending = None if a < 0 else (s, a)
            earlier = left.reward if env.episode_step > n else 0.0
            rewards = np.append(earlier, part.r[max(n - env.episode_step, 0) : n])
            agent.resume_point = ResumePoint(
                env.episode_step, float(rewards.cumsum()[-1]), place_of(env)
            )
        yield n
        if n < len(part.r) or (episodes and not episodes_left):
            return
