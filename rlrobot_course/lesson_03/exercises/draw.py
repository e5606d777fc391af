"""An action drawn with given probabilities."""

from __future__ import annotations

import numpy as np

from rlrobot_course import tapes
from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def draw(p, u):
    total = 0.0
    for a in range(len(p)):
        total += p[a]
        if u < total:
            return a


CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="return the first action at which the running sum of p exceeds u",
    right=draw,
    library=tapes.draw,
    returns="action",
    tape=[
        {"p": np.array(p), "u": u}
        for p, u in (
            ([0.2, 0.3, 0.1, 0.4], 0.45),
            ([0.3, 0.3, 0.4], 0.35),
            ([0.2, 0.5, 0.3], 0.1),
            ([0.2, 0.5, 0.3], 0.9),
            ([0.6, 0.1, 0.1, 0.2], 0.75),
            ([0.1, 0.2, 0.7], 0.25),
            ([0.25, 0.25, 0.25, 0.25], 0.5),
            ([0.0, 1.0, 0.0], 0.0),
            ([0.5, 0.0, 0.5], 0.5),
            ([1.0], 0.3),
            ([0.4, 0.05, 0.3, 0.1, 0.15], 0.97),
            ([0.7, 0.3], 0.65),
        )
    ],
    mistakes={
        "each_alone": Mistake(
            "u is compared with the probability of each action alone. Add up: p(0), then p(0) + p(1), and so on.",
            {"+=": "="},
        ),
        "argmax_of_each": Mistake(
            "p > u compares u with each probability alone. np.cumsum(p) holds the running sums: compare u with these.",
            {"total = 0.0": "return int(np.argmax(p > u))"},
        ),
        "sum_in_the_loop": Mistake(
            "total = 0 stands inside the loop, so nothing adds up. Write it above.", CHANGED["sum_in_the_loop"]
        ),
        "first_twice": Mistake(
            "p[0] is counted twice: total has it before the loop, and the loop adds it again. Begin with 0.",
            {"total = 0.0": "total = p[0]"},
        ),
        "counts_before_it_looks": Mistake(
            "a has already moved on when the loop ends, to the next action. Look before you add 1.",
            CHANGED["counts_before_it_looks"],
        ),
        "misses_u_0": Mistake(
            "u = 0 finds no action here, for the loop ends before it begins. Add p[a] first, then compare; and the sum "
            "must exceed u.",
            CHANGED["misses_u_0"],
        ),
        "ends_in_the_first_round": Mistake(
            "the loop ends in its first round in any case: nothing but the comparison belongs before return.",
            {"total = 0.0": "return None if u < p[0] else 0"},
        ),
        "number_and_share_swapped": Mistake(
            "enumerate gives the number first, then the entry: for a, share in enumerate(p).",
            CHANGED["number_and_share_swapped"],
        ),
        "most_probable": Mistake(
            "this takes the most probable action, whatever u is.", {"total = 0.0": "return int(p.argmax())"}
        ),
        "u_on_the_border": Mistake(
            "u lies exactly on a border here. The running sum must exceed u: write u < sum, not u <= sum. "
            "Otherwise u = 0 may draw an action whose probability is 0.",
            {"u < total": "u <= total"},
        ),
        "inverted": Mistake(
            "the comparison is the wrong way round: the sum must exceed u.", {"u < total": "u > total"}
        ),
        "one_too_early_from_0": Mistake(
            "this is one action too early: the running sum counts p of the action itself, too.",
            {"return a": "return max(a - 1, 0)"},
        ),
        "one_too_early": Mistake(
            "this is one action too early: the running sum counts p of the action itself, too.",
            {"return a": "return a - 1"},
        ),
        "one_too_late": Mistake("this is one action too late. Actions count from 0.", {"return a": "return a + 1"}),
        "ignores_p": Mistake(
            "here all actions are equally probable: p has no effect.", {"total = 0.0": "return int(u * len(p))"}
        ),
        "probability_itself": Mistake(
            "this is the probability of the action. Return its number.", {"return a": "return p[a]"}
        ),
        "sum_itself": Mistake(
            "this is the running sum. Return the number of the action.", {"return a": "return total"}
        ),
        "sorted_up": Mistake(
            "the pieces lie in the order of the actions. They need not be sorted.",
            {"total = 0.0": "p, total = np.sort(p), 0.0"},
        ),
        "sorted_down": Mistake(
            "the pieces lie in the order of the actions. They need not be sorted.",
            {"total = 0.0": "p, total = np.sort(p)[::-1], 0.0"},
        ),
        "from_the_other_end": Mistake(
            "the line is laid from action 0 on. You begin at the other end.", {"u < total": "1 - u < total"}
        ),
        "begins_with_1": Mistake(
            "the loop begins with action 1: range(n) begins with 0.", {"range(len(p))": "range(1, len(p))"}
        ),
        "not_the_last": Mistake("the loop leaves out the last action.", {"range(len(p))": "range(len(p) - 1)"}),
        "only_first_then_next": Mistake(
            "only the first action is looked at: return where u < sum holds, else go on.",
            CHANGED["only_first_then_next"],
        ),
        "only_first_then_last": Mistake(
            "only the first action is looked at: return where u < sum holds, else go on.",
            CHANGED["only_first_then_last"],
        ),
        "looks_before_it_adds": Mistake(
            "u is compared before p of the action has been added. Add first, then compare.",
            CHANGED["looks_before_it_adds"],
        ),
        "first_of_equals": Mistake(
            "index(…) finds the first action with this probability, and two may have the same. Return the number at "
            "which the loop is.",
            {"return a": "return list(p).index(p[a])"},
        ),
        "three_actions": Mistake(
            "this is for three actions. There may be any number: write a loop.",
            {"total = 0.0": "return 0 if u < p[0] else 1 if u < p[0] + p[1] else 2"},
        ),
        "goes_on": Mistake(
            "the loop goes on after the action is found, to the last one. Return at once.", CHANGED["goes_on"]
        ),
        "counts_all": Mistake(
            "this counts the actions whose sum exceeds u. What is asked is the first of them.",
            {"total = 0.0": "return int((np.cumsum(p) > u).sum())"},
        ),
        "nearest_end": Mistake(
            "this takes the piece whose end is nearest to u. What is asked is the piece that u lies in.",
            {"total = 0.0": "return int(abs(np.cumsum(p) - u).argmin())"},
        ),
        "nearest_probability": Mistake(
            "this takes the probability that is nearest to u. What is asked is the piece of the line that u lies in.",
            {"total = 0.0": "return int(abs(p - u).argmin())"},
        ),
        "own_dice": Mistake(
            "u alone decides: the same u, the same action. Your function throws dice of its own.",
            {"total = 0.0": "return int(np.random.default_rng(0).choice(len(p), p=p))"},
        ),
    },
    hints=(
        "Walk along the line from the left. In which piece does u lie?",
        "total begins at 0; for each action add p[a] to it, and stop at the first at which u < total.",
        "for a in range(len(p)): total += p[a]; if u < total: return a. (Each on a line of its own.)",
    ),
    gained="One number u, one action: with the same random numbers your robot will do exactly what the library's does.",
    witnesses=WITNESSES,
)
