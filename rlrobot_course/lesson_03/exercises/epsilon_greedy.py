"""The probabilities of ε-greedy."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def epsilon_greedy(q_s, epsilon):
    best = q_s == q_s.max()
    return epsilon / len(q_s) + (1 - epsilon) * best / best.sum()


ALL = "epsilon / len(q_s) + (1 - epsilon) * best / best.sum()"

WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return the probability of each action: ε / A each, and 1 − ε shared by the best",
    right=epsilon_greedy,
    returns="p",
    tape=[
        {"q_s": np.array(q_s), "epsilon": epsilon}
        for q_s, epsilon in (
            ([2.0, 5.0, 1.0, 5.0, 0.0], 0.2),
            ([-3.0, -2.0, -5.0], 0.61),
            ([3.0, 1.0, 2.0, -8.0], 0.137),
            ([4.0, 4.0, 1.0, 4.0, 3.0, 2.0], 0.25),
            ([2.0, 2.004, 2.002], 0.3),
            ([-0.2, 0.0, -2.0, 0.0], 0.5),
            ([0.0, 0.0, 0.0, 0.0], 0.1),
            ([-1.0, -2.0, -1.0], 0.0),
            ([1.0, 2.0], 1.0),
        )
    ],
    mistakes={
        "first_of_the_best": Mistake(
            "several actions are equally good here, and only the first gets the share of the best. argmax does "
            "that. Find all actions with the largest value.",
            {"q_s == q_s.max()": "np.arange(len(q_s)) == q_s.argmax()"},
        ),
        "last_of_the_best": Mistake(
            "several actions are equally good here, and only the last gets the share of the best. They share it.",
            {"q_s == q_s.max()": "np.arange(len(q_s)) == len(q_s) - 1 - q_s[::-1].argmax()"},
        ),
        "one_each": Mistake(
            "the probabilities sum to more than 1: equally good actions share 1 − ε, they do not get it each.",
            {" / best.sum()": ""},
        ),
        "made_to_sum_1": Mistake(
            "to make the sum 1 afterwards changes ε, too. Share 1 − ε among the best: divide it by their number.",
            {ALL: "(epsilon / len(q_s) + (1 - epsilon) * best) / (epsilon + (1 - epsilon) * best.sum())"},
        ),
        "explores_the_others": Mistake(
            "to explore is to take any action, also the best: divide ε by the number of all actions.",
            {
                "return": "return 1 / len(q_s) + 0 * q_s if best.all() else",
                "epsilon / len(q_s)": "epsilon * ~best / (~best).sum()",
            },
        ),
        "explores_the_others_but_for_ties": Mistake(
            "to explore is to take any action, also the best: divide ε by the number of all actions.",
            {"epsilon / len(q_s)": "epsilon * ~best / max(1, (~best).sum())"},
        ),
        "explores_the_others_by_all": Mistake(
            "to explore is to take any action, also one of the best: divide ε by the number of all actions.",
            {"epsilon / len(q_s)": "epsilon * ~best / (len(q_s) - 1)"},
        ),
        "no_share_for_the_best": Mistake(
            "the best action gets its part of ε, too: without it the sum is below 1.",
            {"epsilon / len(q_s)": "epsilon / len(q_s) * ~best"},
        ),
        "whole_epsilon_each": Mistake(
            "each action gets only its part of ε: divide ε by the number of actions.", {"epsilon / len(q_s)": "epsilon"}
        ),
        "four_actions": Mistake(
            "the part of ε that an action gets does not depend on the number of actions here. It is ε / A, and A is "
            "the length of q_s.",
            {"len(q_s)": "4"},
        ),
        "epsilon_swapped": Mistake(
            "ε and 1 − ε have changed places: ε is the probability to explore.",
            {"epsilon / len": "(1 - epsilon) / len", "(1 - epsilon) * best": "epsilon * best"},
        ),
        "worst": Mistake("the worst actions get the share of the best: max, not min.", {"q_s.max()": "q_s.min()"}),
        "values_for_marks": Mistake(
            "q_s[q_s == q_s.max()] takes the values of the best out. What is needed are the marks: best = q_s == "
            "q_s.max().",
            {"q_s == q_s.max()": "q_s[q_s == q_s.max()]", "best.sum()": "len(best)"},
        ),
        "values_summed": Mistake(
            "q_s[q_s == q_s.max()] takes the values of the best out. What is needed are the marks: best = q_s == "
            "q_s.max().",
            {"q_s == q_s.max()": "q_s[q_s == q_s.max()]", "best.sum()": "best.sum()"},
        ),
        "only_one_of_both": Mistake(
            "the best get 1 − ε in all: shared by their number, and on top of ε / A, which is for every action.",
            {
                "epsilon / len(q_s) + (1 - epsilon) * best / best.sum()": (
                    "np.where(best, 1 - epsilon, epsilon / len(q_s))"
                )
            },
        ),
        "only_one_of_both_scaled": Mistake(
            "the best get 1 − ε in all: shared by their number, and on top of ε / A, which is for every action.",
            {
                "epsilon / len(q_s) + (1 - epsilon) * best / best.sum()": (
                    "(w := np.where(best, 1 - epsilon, epsilon / len(q_s))) / w.sum()"
                )
            },
        ),
        "graded_by_q": Mistake(
            "Q does not grade them: the best share 1 − ε in equal parts, the others get nothing of it.",
            {"best / best.sum()": "q_s / q_s.sum()"},
        ),
        "above_the_mean": Mistake(
            "better than the mean is not yet the best: compare with the largest value of the row.",
            {"q_s == q_s.max()": "q_s >= q_s.mean()"},
        ),
        "more_than_the_mean": Mistake(
            "better than the mean is not yet the best: compare with the largest value of the row.",
            {"q_s == q_s.max()": "q_s > q_s.mean()", "best.sum()": "max(1, best.sum())"},
        ),
        "len_of_marks": Mistake(
            "divide by the number of the best, best.sum(). len(best) counts all actions.", {"best.sum()": "len(best)"}
        ),
        "largest_abs": Mistake(
            "the best are those with the largest value as it is: without abs, for −5 is worse than −2.",
            {"q_s == q_s.max()": "abs(q_s) == abs(q_s).max()"},
        ),
        "above_0": Mistake(
            "values above 0 are not all the best ones: compare with the largest of the row.",
            {"q_s == q_s.max()": "q_s > 0", "best.sum()": "max(1, best.sum())"},
        ),
        "nearly_as_good": Mistake(
            "values that are nearly as good are no ties: only those equal to the largest share 1 − ε.",
            {"q_s == q_s.max()": "np.isclose(q_s, q_s.max(), rtol=0, atol=0.01)"},
        ),
        "one_action": Mistake(
            "this is an action. Return the probabilities of all actions.", {ALL: "int(q_s.argmax())"}
        ),
        "never_explores": Mistake("this never explores: ε has no effect.", {"epsilon": "0"}),
        "own_epsilon": Mistake("ε is an argument. Use it in place of a number.", {"epsilon": "0.1"}),
        "equal": Mistake(
            "all actions are equally probable here. The best ones get 1 − ε on top, and ε / A is for each.",
            {ALL: "1 / len(q_s) + 0 * q_s"},
        ),
        "share_alone": Mistake(
            "each action has its ε / A, but the best still lack their 1 − ε.", {"(1 - epsilon) * best": "0 * best"}
        ),
        "best_alone": Mistake(
            "only the probability of the best is returned. Return an array with one probability an action.",
            {ALL: "1 - epsilon + epsilon / len(q_s)"},
        ),
    },
    hints=(
        "Two parts: each action gets the same share of ε; the best get 1 − ε on top, in equal parts.",
        "best = q_s == q_s.max() marks the best, and best.sum() is their number.",
        "return epsilon / len(q_s) + (1 - epsilon) * best / …: by what must the share of the best be divided?",
    ),
    gained="No tie is left to chance or to argmax: your robot will try every action while it knows nothing.",
    witnesses=WITNESSES,
)
