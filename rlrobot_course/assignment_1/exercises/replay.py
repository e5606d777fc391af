"""Q-learning from a log, from its end to its beginning."""

from __future__ import annotations

from rlrobot_course.assignment_1.given import TARGET
from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import NO_GAMMA, PAST_THE_END
from rlrobot_course.tapes import Q_START


def replay(q, log, alpha, gamma):
    for s, a, r, s_next, terminated in reversed(log):
        target = r if terminated else r + gamma * max(q[s_next])
        q[s, a] += alpha * (target - q[s, a])


LOG = [
    (0, 1, -1.5, 1, False),
    (1, 0, -1.25, 2, False),
    (2, 2, 20.5, 3, True),
    (0, 2, -1.0, 0, False),
    (0, 1, -20.0, 3, True),
]

CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="learn from the steps of the log by Q-learning, the last step first",
    right=replay,
    memory={"q": Q_START},
    tape=[
        {"log": LOG[:1], "alpha": 0.25, "gamma": 0.9},
        {"log": LOG[2:3], "alpha": 0.5, "gamma": 0.9},
        {"log": LOG[:3], "alpha": 0.5, "gamma": 0.8},
        {"log": LOG, "alpha": 0.1, "gamma": 0.95},
        {"log": [], "alpha": 0.1, "gamma": 0.95},
    ],
    mistakes={
        "forwards": Mistake(
            "this begins with the first step. Begin with the last: then each step sees what the next has learned.",
            {"reversed(log)": "log"},
        ),
        "past_the_end": Mistake(PAST_THE_END, {TARGET: "r + gamma * max(q[s_next])"}),
        "no_gamma": Mistake(NO_GAMMA, {"gamma * ": ""}),
        "no_alpha": Mistake("a part of the way is α: change q[s, a] by α times the TD error.", {"alpha * (": "("}),
        "adds_target": Mistake("the TD error is the target minus the old q[s, a].", {"(target - q[s, a])": "target"}),
        "reward_alone": Mistake(
            "this is always the reward alone. Unless the step is terminated, the best of s' counts, too.", {TARGET: "r"}
        ),
        "inverted": Mistake(
            "if is the wrong way round: the reward stands alone where the episode has ended.",
            {"if terminated": "if not terminated"},
        ),
        "skips_the_end": Mistake(
            "a terminated step has a target, too, its reward. Learn from it as from the others.",
            {"q[s, a] +=": "q[s, a] += 0 if terminated else"},
        ),
        "mean": Mistake(
            "this takes the mean over the actions of s'. Q-learning assumes the best one.",
            {"max(q[s_next])": "q[s_next].mean()"},
        ),
        "not_the_last": Mistake(
            "all steps of the log are to be learned from, the last, too.", {"reversed(log)": "reversed(log[:-1])"}
        ),
        "not_the_first": Mistake(
            "all steps of the log are to be learned from, the first, too.", {"reversed(log)": "reversed(log[1:])"}
        ),
        "stops_at_an_end": Mistake(
            "this stops at the first end that it meets. Learn from the whole log.", CHANGED["stops_at_an_end"]
        ),
    },
    hints=(
        "It is Q-learning's update, once for each step of the log. Only the order is new.",
        "for s, a, r, s_next, terminated in reversed(log): target, TD error, q[s, a]. At an end the target is r alone.",
        "target = r if terminated else r + gamma * max(q[s_next]); and below it q[s, a] += alpha * (…)",
    ),
    gained="Backward, one pass carries the reward of the shelf through a whole way; forward, one step of it.",
    witnesses=WITNESSES,
)
