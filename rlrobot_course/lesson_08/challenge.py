"""Open challenge of lesson 08: a way of one's own out of a rut."""

from __future__ import annotations

from typing import Any

from rlrobot_course.challenge import Challenge, Watched, number
from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import steps

COLD, KEPT = 0.01, 50


def read(rule: Any) -> Watched:
    """The learner's rule, which returns a temperature."""
    return Watched(rule, "my_temperature(T, states, rewards)", number(0.001, 1000))


def earned(rule: Watched, seed: int) -> float:
    """Reward a step of a cold robot in its first 800 steps."""
    agent, env = Agent("wander_1k", temperature=COLD, loop_evasion=False, seed=seed), make_env("wander_1k", seed=seed)
    states: list[int] = []
    rewards: list[float] = []
    temperature = COLD
    for step in steps(agent, env, 800):
        states.append(step.s_next)
        rewards.append(step.r)
        temperature = rule(temperature, states[-KEPT:], rewards[-KEPT:])
        agent.change(temperature=temperature)
    return sum(rewards) / len(rewards)


challenge = Challenge(
    "08",
    "Write my_temperature(T, states, rewards), which returns the next temperature, 0.001 to 1000: from the present one "
    "and the latest 50 states and rewards, the newest last. A robot of wander_1k learns with it by TOSL+QBIASSR, and "
    "begins at T = 0.01. What counts is the reward a step in its first 800 steps.",
    "reward a step", read, earned, seeds=16,
)  # fmt: skip
