"""The value of a policy from recorded rows."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import NO_GAMMA


def value_of(rows, policy, n_states, gamma, sweeps):
    v = np.zeros(n_states)
    for _ in range(sweeps):
        old = v.copy()
        for s in range(n_states):
            seen = [r + gamma * old[s_next] for s_row, a, r, s_next in rows if (s_row, a) == (s, policy[s])]
            v[s] = sum(seen) / len(seen) if seen else 0
    return v


ROWS = [
    (0, 0, 1.5, 1),
    (0, 0, 2.5, 0),
    (0, 1, -3.5, 2),
    (1, 1, 4.5, 2),
    (1, 1, 0.5, 1),
    (1, 1, 1.25, 0),
    (1, 0, 9.5, 1),
    (2, 0, -0.5, 0),
    (0, 0, 1.5, 1),
    (2, 1, 7.5, 2),
]

WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return the value of each state under the policy, after so many sweeps over the recording",
    right=value_of,
    returns="v",
    tape=[
        {"rows": rows, "policy": policy, "n_states": n, "gamma": gamma, "sweeps": sweeps}
        for rows, policy, n, gamma, sweeps in (
            (ROWS, [0, 1, 0], 3, 0.9, 1),
            (ROWS, [0, 1, 0], 3, 0.8, 2),
            (ROWS, [1, 0, 1], 3, 0.75, 12),
            (ROWS[:6], [0, 1, 1], 3, 0.9, 3),
            (ROWS, [0, 1, 0], 3, 0.5, 40),
            ([], [0, 0], 2, 0.9, 5),
        )
    ],
    mistakes={
        "best_actions": Mistake(
            "this is the value of the best actions. Asked is that of the policy: only rows in which a is policy[s].",
            {"if (s_row, a) == (s, policy[s])": "if s_row == s"},
        ),
        "no_gamma": Mistake(NO_GAMMA, {"gamma * ": ""}),
        "no_reward": Mistake("the rewards are missing.", {"r + gamma": "gamma"}),
        "reward_alone": Mistake(
            "these are rewards alone: what follows counts γ times, by the values of the sweep before.",
            {"r + gamma * old[s_next]": "r"},
        ),
        "sums": Mistake(
            "this adds up all rows. Each of them is one of several things that may happen: take their mean.",
            {"sum(seen) / len(seen)": "sum(seen)"},
        ),
        "within_a_sweep": Mistake(
            "values change within the sweep. All of a sweep come from those of the sweep before: keep a copy.",
            {"old = v.copy()": "old = v"},
        ),
        "share_of_all_rows": Mistake(
            "the share of a row is among those of its pair (s, a), not among all rows.", {"/ len(seen)": "/ len(rows)"}
        ),
        "untried_counts_1": Mistake("a pair that was never tried counts 0 here.", {"if seen else 0": "if seen else 1"}),
        "one_sweep_short": Mistake("a sweep is missing.", {"range(sweeps)": "range(sweeps - 1)"}),
        "value_of_s": Mistake("what follows is worth v[s'], not v[s].", {"old[s_next]": "old[s]"}),
        "luckiest": Mistake(
            "not the luckiest row counts, but the mean of them.", {"sum(seen) / len(seen)": "max(seen)"}
        ),
    },
    hints=(
        "One state, one sweep: look for the rows that begin in s with policy[s]. What has each of them come to, and "
        "what is their mean?",
        "Of one row it is r + gamma * old[s_next], old being the values before this sweep: old = v.copy().",
        "seen = [r + gamma * old[s_next] for s_row, a, r, s_next in rows if …]; v[s] = sum(seen) / len(seen), or 0 if "
        "there is none.",
    ),
    gained="A recording of one robot tells what another would earn that behaves otherwise, and nobody had to drive.",
    witnesses=WITNESSES,
)
