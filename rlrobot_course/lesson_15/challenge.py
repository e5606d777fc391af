"""Open challenge of lesson 15: to tell the better of two methods with few agents."""

from typing import Any

import numpy as np

from rlrobot_course.play.challenge import Challenge, Watched

MOST, WRONG = 100, 100  # agents of each method; agents that a wrong verdict costs
VERDICTS = ("a", "b", "more")


def verdict_of(value: Any) -> str:
    """Reads a verdict. Raises ValueError if it is none."""
    if not isinstance(value, str) or value not in VERDICTS:
        raise ValueError('"a", "b" or "more" is expected')
    return value


def cost(verdict: Watched, seed: int) -> float:
    """The agents that one comparison took; a wrong verdict, or none, counts as 100 more."""
    rng = np.random.default_rng(seed)
    better, apart = "ab"[int(rng.integers(2))], rng.choice([0.3, 0.6, 1.2])
    ends = {
        name: 5 + apart * (name == better) + rng.standard_normal(MOST) for name in "ab"
    }
    for n in range(2, MOST + 1):
        told = verdict(ends["a"][:n].copy(), ends["b"][:n].copy())
        if told != "more":
            break
    return float(2 * n + WRONG * (told != better))


challenge = Challenge(
    "15",
    "Write my_verdict(a, b): two arrays of final average rewards, of as many agents of method a as of b. Return the "
    'better method, "a" or "b", or "more" for another agent of each, up to 100. The SD is 1 in both, and the true '
    "means are 0.3, 0.6 or 1.2 apart. What counts is how many agents you ask for, and 100 more for a wrong verdict, "
    "mean of 300 pairs.",
    "agents", lambda verdict: Watched(verdict, "my_verdict(a, b)", verdict_of), cost,
    seeds=300, least_wins=True,
)  # fmt: skip
