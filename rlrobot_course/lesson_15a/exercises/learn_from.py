"""Q-learning from a recording."""

from __future__ import annotations

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.tapes import Q_START, TAPE


def learn_from(q, rows, alpha, gamma):
    for s, a, r, s_next, terminated in rows:
        best = 0 if terminated else max(q[s_next])
        q[s, a] = q[s, a] + alpha * (r + gamma * best - q[s, a])


_ROWS = [tuple(row[name] for name in ("s", "a", "r", "s_next", "terminated")) for row in TAPE]

# Recordings of one row, of an episode, of what was cut off, of several episodes; and one that comes back to its pairs.
_PARTS = ((0, 1), (4, 5), (0, 5), (5, 8), (0, 9), (0, 0))

_BEST = "0 if terminated else max(q[s_next])"

_STEP = "q[s, a] + alpha * (r + gamma * best - q[s, a])"

CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="go through the rows and let Q-learning learn from each",
    right=learn_from,
    memory={"q": Q_START},
    tape=[
        {"rows": _ROWS[first:last], "alpha": alpha, "gamma": gamma}
        for (first, last), alpha, gamma in zip(
            _PARTS, (0.1, 0.5, 0.2, 0.3, 0.1, 0.1), (0.9, 0.8, 0.9, 0.7, 0.95, 0.9), strict=True
        )
    ],
    mistakes={
        "past_the_end": Mistake(
            "this bootstraps past the end. After a terminal row nothing follows, so the target is the reward alone.",
            {_BEST: "max(q[s_next])"},
        ),
        "inverted": Mistake(
            "the if is the wrong way round: nothing follows where the episode has ended.",
            {"0 if terminated else max": "0 if not terminated else max"},
        ),
        "one_row": Mistake("only one row has been learned: is return, or break, inside the loop?", CHANGED["one_row"]),
        "skips_the_end": Mistake(
            "a terminal row is a row to learn from, too, often the best one. Do not skip it.", CHANGED["skips_the_end"]
        ),
        "stops_at_an_end": Mistake(
            "the rows go on after an episode has ended: do not stop at terminated.", CHANGED["stops_at_an_end"]
        ),
        "backwards": Mistake(
            "the rows are gone through backwards. A clever idea, but the exercise asks for their order.",
            {"in rows": "in rows[::-1]"},
        ),
        "not_the_last": Mistake(
            "the last row is left out. Q-learning needs no next row, so it can learn from it.",
            {"in rows": "in rows[:-1]"},
        ),
        "sarsa": Mistake(
            "the recorded action takes the place of the best one only in SARSA. Q-learning looks at max Q(s', ·).",
            {"max(q[s_next])": "q[s_next, a]"},
        ),
        "value_of_s": Mistake("look ahead into the row of s', not of s.", {"max(q[s_next])": "max(q[s])"}),
        "no_gamma": Mistake("you forgot γ.", {"gamma * ": ""}),
        "no_reward": Mistake("the reward is missing in the target: r + γ · the best of s'.", {"(r + gamma": "(gamma"}),
        "adds_target": Mistake(
            "you forgot − Q(s, a): the update goes a part α of the way from Q(s, a) to the target.",
            {" - q[s, a])": ")"},
        ),
        "no_alpha": Mistake("you forgot α: the update goes only a part of the way.", {"alpha * ": ""}),
        "replaces": Mistake("the old Q(s, a) is lost: add to it.", {f"= {_STEP}": f"= {_STEP.partition(' + ')[2]}"}),
        "downwards": Mistake("the sign: Q(s, a) moves towards the target.", {"q[s, a] + alpha": "q[s, a] - alpha"}),
        "writes_to_s_next": Mistake(
            "this learns in the row of s'. It is Q(s, a), of the state in which the action was taken.",
            {f"q[s, a] = {_STEP}": f"q[s_next, a] = {_STEP.replace('q[s, a]', 'q[s_next, a]')}"},
        ),
        "mean": Mistake(
            "the mean over the actions is not Q-learning: it takes the best one.",
            {"max(q[s_next])": "q[s_next].mean()"},
        ),
        "invents_rewards": Mistake(
            "what the teacher did is not made better by hand: learn from r, whatever the action was.",
            {_STEP: "q[s, a] + 1"},
        ),
    },
    hints=(
        "Nobody chooses here: s, a, r and s' all stand in the row. Of the loop of lesson 02 its update is left.",
        "for s, a, r, s_next, terminated in rows: and inside it the two lines of an update.",
        "best = 0 if terminated else max(q[s_next]); then q[s, a] = q[s, a] + alpha * (… − q[s, a])",
    ),
    gained="Two lines and a loop turn what a person did into what an agent knows. Below it teaches your own agent.",
    witnesses=WITNESSES,
)
