"""The update of Watkins's Q(λ)."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import FADES_BY_BOTH, PAST_THE_END


def watkins_update(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    best = 0 if terminated else max(q[s_next])
    greedy = not terminated and q[s_next, a_next] == best
    delta = r + gamma * best - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma * lam if greedy else 0


Q = np.array([[0.5, 2.0, 2.0], [4.0, -1.0, 5.5], [0.75, 0.75, 0.75], [0.0, 6.0, 7.0]])

STEPS = (
    (0, 1, 10.0, 2, 1, False),  # a tie in s', and a' is not the first of the best
    (2, 1, -0.5, 1, 2, False),
    (1, 2, 1.5, 0, 0, False),  # a' explores: cut
    (0, 0, -2.0, 1, 2, False),
    (1, 2, -30.5, 1, 2, False),  # a' was best, and this very step makes it worse
    (1, 2, 0.25, 2, 0, False),
    (2, 0, 2.5, 3, 0, True),
    (0, 2, 1.25, 1, 0, False),
    (1, 0, 0.5, 2, 2, False),
    (2, 2, -1.25, 3, 2, True),
    (1, 1, 4.5, 0, 1, False),
)

COLUMNS = ("s", "a", "r", "s_next", "a_next", "terminated")

CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="Q-learning's update with replacing traces, which are cut where a' is not a best action",
    right=watkins_update,
    memory={"q": Q, "e": np.zeros_like(Q)},
    tape=[
        dict(zip(COLUMNS, step, strict=True)) | {"alpha": alpha, "gamma": gamma, "lam": lam}
        for step, alpha, gamma, lam in zip(
            STEPS,
            (0.1, 0.5, 0.25, 0.1, 0.4, 0.3, 0.7, 0.05, 0.2, 0.4, 0.3),
            (0.9, 0.5, 0.8, 0.9, 0.9, 0.95, 0.9, 0.6, 0.9, 0.7, 0.8),
            (0.9, 0.8, 0.7, 0.6, 0.9, 0.8, 0.9, 0.5, 0.9, 0.8, 0.7),
            strict=True,
        )
    ],
    mistakes={
        "past_the_end": Mistake(
            PAST_THE_END,
            {"best = 0 if terminated else max(q[s_next])": "best = max(q[s_next])"},
        ),
        "never_cut": Mistake(
            "the traces are never cut. Where a' is not a best action, they become 0.",
            {" if greedy else 0": " if not terminated else 0"},
        ),
        "cut_inverted": Mistake(
            "the cut is the wrong way round: the traces live on where a' is a best action.",
            {"if greedy": "if not greedy"},
        ),
        "lives_past_the_end": Mistake(
            "after a terminated step all traces are 0: the next episode has nothing to do with this one.",
            {
                "greedy = not terminated and q[s_next, a_next] == best": (
                    "greedy = terminated or q[s_next, a_next] == best"
                )
            },
        ),
        "greedy_after_update": Mistake(
            "whether a' is a best action, the table tells as it was before the update. Ask first, then change it.",
            CHANGED["greedy_after_update"],
        ),
        "first_of_the_best": Mistake(
            "of several best actions argmax knows the first alone. a' is a best one if its value is the largest.",
            {"q[s_next, a_next] == best": "a_next == q[s_next].argmax()"},
        ),
        "sarsa": Mistake(
            "this is SARSA's target. Watkins keeps Q-learning's: the best action of s'.",
            {"gamma * best": "gamma * (0 if terminated else q[s_next, a_next])"},
        ),
        "cut_before_update": Mistake(
            "the traces are cut before this step has taught anything. First the update, then the cut.",
            CHANGED["cut_before_update"],
        ),
        "visited_pair_cut": Mistake(
            "the visited pair is cut as well before it learns: set its trace to 1, update, and cut then.",
            CHANGED["visited_pair_cut"],
        ),
        "accumulates": Mistake(
            "this is an accumulating trace. Here it is replaced: the visited pair's is set to 1.",
            {"e[s, a] = 1": "e[s, a] += 1"},
        ),
        "no_gamma_in_fading": Mistake(FADES_BY_BOTH, {"e *= gamma * lam": "e *= lam"}),
        "no_fading": Mistake(
            "where the traces live on, they still fade, by γ · λ.", {"gamma * lam if greedy": "1 if greedy"}
        ),
        "only_one_pair_learns": Mistake(
            "only (s, a) learns. With traces all pairs do, each times its trace: q += α δ e.",
            {"q += alpha * delta * e": "q[s, a] += alpha * delta"},
        ),
    },
    hints=(
        "The update is SARSA(λ)'s with Q-learning's δ. Then one question decides what becomes of the traces.",
        "Before q changes: is q[s_next, a_next] equal to the largest of q[s_next]? If so the traces fade, if not, or "
        "at an end, they are 0.",
        "e[s, a] = 1, then q += alpha * delta * e, then e *= gamma * lam if … else 0.",
    ),
    gained="Off-policy with traces: it learns about the best policy, and credits what that policy would have done.",
    witnesses=WITNESSES,
)
