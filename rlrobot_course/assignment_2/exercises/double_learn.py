"""The loop of double Q-learning."""

from __future__ import annotations

from rlrobot_course.assignment_2.exercises.double_update import double_update
from rlrobot_course.assignment_2.given import OTHER
from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.tapes import Q_START, Chooser, PatientWorld


def double_learn(env, q1, q2, choose, toss, episodes, alpha, gamma):
    for _ in range(episodes):
        s, over = env.reset(), False
        while not over:
            a = choose(q1 + q2, s)
            s_next, r, terminated, truncated = env.step(a)
            double_update(q1, q2, s, a, r, s_next, terminated, toss(), alpha, gamma)
            s, over = s_next, terminated or truncated


class Coin:
    """Falls as it was told beforehand, again and again."""

    def __init__(self, *falls: bool) -> None:
        self.falls, self.n = falls, 0

    def __call__(self) -> bool:
        """Toss: True for heads."""
        self.n += 1
        return self.falls[(self.n - 1) % len(self.falls)]


STEP = "double_update(q1, q2, s, a, r, s_next, terminated, toss(), alpha, gamma)"

CHANGED, WITNESSES = read_answers(__file__, {"double_update": double_update})

exercise = Exercise(
    task="learn for so many episodes with two tables, choosing by their sum, with a toss for each step",
    right=double_learn,
    memory={"env": PatientWorld(), "q1": Q_START, "q2": OTHER},
    lenders={"double_update": "your function of exercise 4"},
    tape=[
        {"choose": Chooser(rank), "toss": Coin(*falls), "episodes": n, "alpha": alpha, "gamma": gamma}
        for rank, falls, n, alpha, gamma in (
            (0, (True, False), 1, 0.5, 0.9),
            (1, (False, True, True), 2, 0.25, 0.8),
            (2, (False, False, True), 3, 0.4, 0.7),
        )
    ],
    mistakes={
        "q1_alone": Mistake("only q1 chooses. Both tables have learned: choose by their sum.", {"q1 + q2": "q1"}),
        "q2_alone": Mistake("only q2 chooses. Both tables have learned: choose by their sum.", {"q1 + q2": "q2"}),
        "always_heads": Mistake(
            "the coin is tossed anew for each step; yours always falls the same way.", {"toss()": "True"}
        ),
        "one_toss_an_episode": Mistake(
            "one toss for a whole episode is too few: toss the coin in each step.", CHANGED["one_toss_an_episode"]
        ),
        "only_terminated_is_over": Mistake(
            "an episode is over when it is truncated, too.", {"terminated or truncated": "terminated"}
        ),
        "truncated_as_terminated": Mistake(
            "a truncated step has only run out of time: hand over terminated alone.",
            {"s_next, terminated, toss()": "s_next, terminated or truncated, toss()"},
        ),
        "stays": Mistake("s stays where it was: go on from s_next.", {"s, over = s_next,": "s, over = s,"}),
        "skips_the_end": Mistake(
            "a terminated step teaches, too: its target is the reward alone. Update in every step.",
            {STEP: f"if not terminated: {STEP}"},
        ),
        "states_swapped": Mistake(
            "s and s_next have changed places in the update.",
            {STEP: "double_update(q1, q2, s_next, a, r, s, terminated, toss(), alpha, gamma)"},
        ),
        "alpha_and_gamma_swapped": Mistake(
            "α and γ have changed places in the update.",
            {STEP: "double_update(q1, q2, s, a, r, s_next, terminated, toss(), gamma, alpha)"},
        ),
        "resets_once": Mistake("the world is reset at the start of each episode.", CHANGED["resets_once"]),
    },
    hints=(
        "The loop of lesson 02, by episodes, with two tables: what chooses, and what learns, in each step?",
        "Inside: a = choose(q1 + q2, s), then the step, then double_update(…, toss(), alpha, gamma), then go on.",
        "s, over = env.reset(), False; while not over: …; and the last line is s, over = s_next, terminated or "
        "truncated.",
    ),
    gained="That is double Q-learning (van Hasselt, 2010). Below, a hundred robots try it.",
    witnesses=WITNESSES,
)
