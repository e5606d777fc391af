"""Right answers and tapes of lesson 06a; what is asked, hints and mistakes stand on the pages beside."""

import numpy as np

from rlrobot_course.grading.parts import Exercise, with_pages
from rlrobot_course.tapes import OTHER_Q, Q_START, TAPE


def expected_target(q, p, r, s_next, terminated, gamma):
    if terminated:
        return r
    return r + gamma * sum(p * q[s_next])


# Another world for the last cases: two actions, and values with many digits.
# How probable each action is in s'. The most probable one is not always the best, as after a change of Q.
POLICIES = ((0.8, 0.15, 0.05), (0.5, 0.3, 0.2), (0.2, 0.5, 0.3), (0.0, 1.0, 0.0), (0.6, 0.3, 0.1))
OTHER_CASES = (
    {"q": OTHER_Q, "p": np.array((0.37, 0.63)), "gamma": 0.5, "r": -0.3, "s_next": 0, "terminated": False},
    {"q": OTHER_Q, "p": np.array((0.1, 0.9)), "gamma": 0.99, "r": 0.0, "s_next": 2, "terminated": False},
    {"q": OTHER_Q, "p": np.array((0.2, 0.8)), "gamma": 0.7, "r": -1.25, "s_next": 1, "terminated": True},
)

check = with_pages(
    globals(),
    expected_target=Exercise(
        expected_target,
        returns="target",
        tape=[
            {"q": Q_START, "p": np.array(p), "gamma": gamma}
            | {name: row[name] for name in ("r", "s_next", "terminated")}
            for p, gamma, row in zip(POLICIES, (0.9, 0.8, 0.95, 0.7, 0.9), TAPE, strict=False)
        ]
        + [*OTHER_CASES],
    ),
)
