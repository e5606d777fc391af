"""Probabilities and mean rewards from recorded rows."""

from __future__ import annotations

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.replay import Case
from rlrobot_course.grading.shared_hints import WHOLE_DIVISION
from rlrobot_course.lesson_13.given import ROWS, THE_PAIR


def estimate(rows, s, a):
    rewards = {}
    for s_row, a_row, r, s_next in rows:
        if (s_row, a_row) == (s, a):
            rewards.setdefault(s_next, []).append(r)
    n = sum(len(seen) for seen in rewards.values())
    return {s_next: (len(seen) / n, sum(seen) / len(seen)) for s_next, seen in rewards.items()}


ASKED = [(0, 1), (1, 1), (0, 0), (2, 0), (3, 1), (2, 1)]

BOTH = "(len(seen) / n, sum(seen) / len(seen))"

WITNESSES = read_answers(__file__, {})[1]


class OfRows(Exercise):
    """The whole table is long; what counts of it is shown, the rows of the pair."""

    def _called(self, case: Case) -> str:
        rows = ", ".join(str(row) for row in case["rows"] if row[:2] == (case["s"], case["a"]))
        return f"s = {case['s']}, a = {case['a']}; rows of this pair: {rows}; and {len(case['rows'])} rows in all"


exercise = OfRows(
    task="return, for every next state that was seen after (s, a), its probability and its mean reward",
    right=estimate,
    returns="estimate",
    tape=[{"rows": ROWS, "s": s, "a": a} for s, a in ASKED],
    mistakes={
        "divides_by_all_rows": Mistake(
            "the counts are divided by the number of all rows. Divide by how often this pair was tried.",
            {"sum(len(seen) for seen in rewards.values())": "len(rows)"},
        ),
        "other_actions": Mistake(
            "rows with other actions are counted, too. Both have to agree, s and a.", {THE_PAIR: "s_row == s"}
        ),
        "other_states": Mistake(
            "rows from other states are counted, too. Both have to agree, s and a.", {THE_PAIR: "a_row == a"}
        ),
        "counts": Mistake(
            "these are counts. A probability is a count divided by how often the pair was tried.",
            {"len(seen) / n": "len(seen)"},
        ),
        "sums": Mistake(
            "the rewards are added up. Their mean is asked: divide by how many there are.",
            {"sum(seen) / len(seen)": "sum(seen)"},
        ),
        "divides_by_the_pair": Mistake(
            "the rewards of one next state are divided by how often the pair was tried. Divide by how often it led "
            "to this next state.",
            {"sum(seen) / len(seen)": "sum(seen) / n"},
        ),
        "swapped": Mistake(
            "the two have changed places: first the probability, then the mean reward.",
            {BOTH: "(sum(seen) / len(seen), len(seen) / n)"},
        ),
        "last_reward": Mistake(
            "this is the last reward that was seen there. Take the mean of all.", {"sum(seen) / len(seen)": "seen[-1]"}
        ),
        "first_reward": Mistake(
            "this is the first reward that was seen there. Take the mean of all.", {"sum(seen) / len(seen)": "seen[0]"}
        ),
        "largest_reward": Mistake(
            "this is the largest reward that was seen there. Take the mean of all.",
            {"sum(seen) / len(seen)": "max(seen)"},
        ),
        "each_reward_once": Mistake(
            "each different reward counts once here. A reward counts as often as it was seen.",
            {"sum(seen) / len(seen)": "sum(set(seen)) / len(set(seen))"},
        ),
        "equal_probabilities": Mistake(
            "all next states get the same probability. Count how often each of them came.",
            {"len(seen) / n": "1 / len(rewards)"},
        ),
        "mean_of_the_pair": Mistake(
            "this is the mean reward of the pair, whatever came next. Each next state has a mean of its own.",
            {"sum(seen) / len(seen)": "sum(map(sum, rewards.values())) / n"},
        ),
        "rows_that_end_in_s": Mistake(
            "a row belongs to the pair by the state it begins in, its first number; s′ is its last.",
            {THE_PAIR: "(s_next, a_row) == (s, a)"},
        ),
        "probability_alone": Mistake(
            "only the probability is here. The mean reward belongs beside it: a tuple of two for each next state.",
            {BOTH: "len(seen) / n"},
        ),
        "reward_alone": Mistake(
            "only the mean reward is here. The probability stands before it: a tuple of two for each next state.",
            {BOTH: "sum(seen) / len(seen)"},
        ),
        "whole_division": Mistake(WHOLE_DIVISION, {"len(seen) / n": "len(seen) // n"}),
        "divides_by_the_state": Mistake(
            "the counts are divided by how often the state was visited. Divide by how often this pair was tried.",
            {"sum(len(seen) for seen in rewards.values())": "sum(row[0] == s for row in rows)"},
        ),
        "per_cent": Mistake(
            "this is in per cent. A probability lies between 0 and 1.", {"len(seen) / n": "100 * len(seen) / n"}
        ),
        "keyed_by_s": Mistake(
            "the states in s are taken for those in s′: the keys are next states.",
            {"setdefault(s_next, [])": "setdefault(s_row, [])"},
        ),
    },
    hints=(
        "Go through the rows once, and keep for each next state the rewards that came with it. Their number gives the "
        "probability, their mean the reward.",
        "A dict of lists: rewards.setdefault(s_next, []).append(r) for each row of the pair. n is how many rows the "
        "pair has.",
        "return {s_next: (len(seen) / n, sum(seen) / len(seen)) for s_next, seen in rewards.items()}",
    ),
    gained="These are T and R, the two tables that a model of a world consists of.",
    witnesses=WITNESSES,
)
