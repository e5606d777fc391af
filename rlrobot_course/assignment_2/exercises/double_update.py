"""The update of double Q-learning."""

from __future__ import annotations

from rlrobot_course.assignment_2.given import OTHER
from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import NO_GAMMA, PAST_THE_END
from rlrobot_course.tapes import Q_START, TAPE


def double_update(q1, q2, s, a, r, s_next, terminated, heads, alpha, gamma):
    learns, judges = (q1, q2) if heads else (q2, q1)
    best = learns[s_next].argmax()
    target = r if terminated else r + gamma * judges[s_next, best]
    learns[s, a] += alpha * (target - learns[s, a])


HEADS = (True, False, True, False, True, True, False, False, False)

ALPHAS = (0.1, 0.5, 0.25, 0.1, 0.4, 0.3, 0.7, 0.05, 0.2)

GAMMAS = (0.9, 0.5, 0.8, 0.9, 0.9, 0.95, 0.9, 0.6, 0.9)


WITNESSES = read_answers(__file__, {"double_update": double_update})[1]

exercise = Exercise(
    task="change the table that the coin has picked: its best action of s' counts as the other table says",
    right=double_update,
    memory={"q1": Q_START, "q2": OTHER},
    tape=[
        {name: row[name] for name in ("s", "a", "r", "s_next", "terminated")}
        | {"heads": heads, "alpha": alpha, "gamma": gamma}
        for row, heads, alpha, gamma in zip(TAPE, HEADS, ALPHAS, GAMMAS, strict=True)
    ],
    mistakes={
        "past_the_end": Mistake(PAST_THE_END, {"r if terminated else": ""}),
        "q_learning": Mistake(
            "this is Q-learning in one table: what learns picks the best action of s' and tells its worth, too. "
            "The worth must come from the other one.",
            {"judges[s_next, best]": "learns[s_next, best]"},
        ),
        "judge_picks_too": Mistake(
            "the other table picks and judges. The table that learns picks the action; the other tells its worth.",
            {"learns[s_next].argmax()": "judges[s_next].argmax()"},
        ),
        "picker_and_judge_swapped": Mistake(
            "picker and judge have changed places: the table that learns picks, the other judges.",
            {"learns[s_next].argmax()": "judges[s_next].argmax()", "judges[s_next, best]": "learns[s_next, best]"},
        ),
        "heads_inverted": Mistake("heads is the wrong way round: with heads q1 learns.", {"if heads": "if not heads"}),
        "no_coin": Mistake("the coin is not looked at: q1 learns always.", {"if heads": "if True"}),
        "both_learn": Mistake(
            "both tables change. A step teaches one of them, as the coin has fallen.",
            {
                "learns[s, a] += alpha * (target - learns[s, a])": (
                    "learns[s, a] += alpha * (target - learns[s, a]); judges[s, a] += alpha * (target - judges[s, a])"
                )
            },
        ),
        "gap_from_the_judge": Mistake(
            "the TD error is the target minus the old value of the table that learns.",
            {"target - learns[s, a]": "target - judges[s, a]"},
        ),
        "no_gamma": Mistake(NO_GAMMA, {"gamma * ": ""}),
        "argmax": Mistake(
            "argmax tells which action is best; the target needs how much it is worth, in the other table.",
            {"judges[s_next, best]": "best"},
        ),
        "picks_in_s": Mistake(
            "the action is picked in s. It is s' in which the best action is looked for.",
            {"learns[s_next].argmax()": "learns[s].argmax()"},
        ),
    },
    hints=(
        "Write it for heads first: q1 learns. Its own argmax picks the action of s', and q2 tells what that is worth.",
        "To write it once only: learns, judges = (q1, q2) if heads else (q2, q1).",
        "best = learns[s_next].argmax(); the target is r, or r + gamma * judges[s_next, best]; then learns[s, a] += …",
    ),
    gained="Two tables, and each is judged by one that had other luck.",
    witnesses=WITNESSES,
)
