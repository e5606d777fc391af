"""What the reader of lesson 09 moves: the step, over what the rule of loop evasion sees in two robots' queues."""

from collections.abc import Mapping, Sequence

from rlrobot_course.handles.handle import Handle
from rlrobot_course.lesson_09.queues import (
    LENGTH,
    Walk,
    first_heat,
    plot_watched,
    watch,
)
from rlrobot_edu.learning.loop import Step
from rlrobot_edu.learning.loop_evasion import watch_for_loops


def redundancy(m):
    """How often a state is in the queue, on average. m: the agent's memory, see rlrobot_edu/learning/memory.py"""
    return m.now.queue_size / m.now.queue_unique


def mean_reward(m):
    """The mean of the rewards in the queue. m: as above"""
    total = 0.0
    for i in range(m.now.queue_size):
        total += m.queue_rewards[i]
    return total / m.now.queue_size


def watch_robots(robots: Mapping[str, Sequence[Step]], default: float) -> Handle:
    """What the rule sees in each step; it opens where the first robot's temperature first rises.

    robots: two, by name, as many steps of each, from `rl.steps`; default: the temperature outside loops
    """
    walks = {}
    for name, steps in robots.items():
        states = [int(step.s_next) for step in steps]
        walks[name] = Walk(states, [float(step.r) for step in steps])
    first, *_ = walks.values()
    feed = {
        "names": list(walks),
        "states": [walk.states for walk in walks.values()],
        "rewards": [walk.rewards for walk in walks.values()],
        "length": LENGTH,
        "cold": default,
        "opening": first_heat(watch(first, default), default),
    }
    return Handle(
        "What the rule of loop evasion sees",
        __package__,
        ["loops.js"],
        feed,
        plot_watched(walks, default),
        {
            "watch_for_loops": watch_for_loops,
            "redundancy": redundancy,
            "mean_reward": mean_reward,
        },
    )
