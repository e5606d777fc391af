"""A whole learning process in a world of kernels. A template, with Q+SR's steps and a world that waits.

begin: (world, rng) -> state in which an episode begins
outcome: (world, s, a, rng) -> (s', r, terminated)

A state below 0: the world cannot tell, and is as if it had not been asked.
"""

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.step import begin_episode
from rlrobot_edu.learning.templates.step import learn_step, select

planned_step = None  # of an agent that plans


@compiled
def begin(world, rng):
    """The part of a world: this one cannot tell."""
    return -1


@compiled
def outcome(world, s, a, rng):
    """The part of a world: this one cannot tell."""
    return -1, 0.0, False


@compiled
def run(world, m, x, world_rng, agent_rng, at, log):
    """Let the agent with memory `m` learn until the log is full, or until there are no episodes left.

    `x` is its experience, None without a planner.

    `at` holds (s, a, episode_step, steps, episodes): where to go on, a < 0 for a new episode; the steps
    done; and the episodes left, where 0 is no limit.
    The same loop, step for step and draw for draw, as `learning.loop.steps` over the world's environment. It ends
    sooner where the world cannot tell.
    """
    limit = world.episode_steps
    s, a, episode_step = at[0], at[1], at[2]
    log_s, log_a, log_r, log_s_next = log.s, log.a, log.r, log.s_next
    log_terminated, log_truncated = log.terminated, log.truncated
    for t in range(log_r.shape[0]):
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
        u = agent_rng.random()
        if planned_step is None:
            a_next, _ = learn_step(m, s, a, r, s_next, end, u)
        else:
            a_next, _ = planned_step(m, x, s, a, r, s_next, end, u, agent_rng)
        episode_step += 1
        cut = episode_step >= limit and not end
        log_s[t] = s
        log_a[t] = a
        log_r[t] = r
        log_s_next[t] = s_next
        log_terminated[t] = end
        log_truncated[t] = cut
        s, a = s_next, a_next
        if cut:
            a = -1
        at[0], at[1], at[2], at[3] = s, a, episode_step, t + 1
        if end or cut:
            at[4] -= 1
            if at[4] == 0:
                return
