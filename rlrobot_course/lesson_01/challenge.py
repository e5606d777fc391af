"""Open challenge of lesson 01: a reward of one's own, by which the robot drives far and touches nothing."""

from typing import Any

from rlrobot_course.challenge import Challenge, Watched, number
from rlrobot_course.paid import Paid
from rlrobot_edu import Agent, learn, make_env
from rlrobot_edu.task.reward_parts import distance_moved

LASERS = ("laser_front_left", "laser_front_right")


def metres(reward: Watched, seed: int) -> float:
    """How far a robot drives in 100 steps without touching a wall, after 600 steps of learning [m]."""
    ways = []

    def pay(before: Any, after: Any, r: float, terminated: bool) -> float:
        way = distance_moved(before, after)
        drives = way > 0.07 and min(after[laser] for laser in LASERS) >= 0.10
        ways.append(way if drives else 0.0)
        return float(reward(dict(before), dict(after)))

    env = Paid(make_env("wander_simple", seed=seed), pay)
    learn(Agent(env, "Q+SR", loop_evasion=False, seed=seed), env, steps=700, progress=False)
    return sum(ways[-100:])


challenge = Challenge(
    "01",
    "Write my_reward(before, after), any number from −10 to 10. A robot of wander_simple learns with it for 600 steps. "
    "What counts is how far it drives in the next 100, in steps of more than 0.07 m that end 0.10 m from all walls.",
    "m in 100 steps", lambda reward: Watched(reward, "my_reward(before, after)", number(-10, 10)), metres,
)  # fmt: skip
