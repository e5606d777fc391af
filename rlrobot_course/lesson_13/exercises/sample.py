"""A recorded row drawn by chance."""

from __future__ import annotations

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.lesson_13.given import ROWS, THE_PAIR


def sample(rows, s, a, u):
    seen = [(s_next, r) for s_row, a_row, r, s_next in rows if (s_row, a_row) == (s, a)]
    return seen[int(u * len(seen))] if seen else None


DRAWN = "seen[int(u * len(seen))]"

DRAWS = [
    (0, 1, 0.5),
    (0, 1, 0.0),
    (0, 1, 0.2),
    (0, 1, 0.93),
    (0, 1, 0.72),
    (1, 1, 0.6),
    (1, 1, 0.99),
    (0, 0, 0.51),
    (2, 0, 0.99),
    (2, 0, 0.0),
    (3, 1, 0.4),
    (2, 1, 0.3),
    (0, 1, 0.14),
    (0, 1, 0.45),
    (0, 1, 0.36),
]

WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return s′ and r of one of the rows of (s, a), the row number int(u · n) of the n that there are; None if "
    "there is none",
    right=sample,
    returns="outcome",
    tape=[{"rows": ROWS, "s": s, "a": a, "u": u} for s, a, u in DRAWS],
    mistakes={
        "swapped": Mistake("the two have changed places: first s′, then r.", {"(s_next, r) for": "(r, s_next) for"}),
        "other_actions": Mistake(
            "rows with other actions are drawn, too. Both have to agree, s and a.", {THE_PAIR: "s_row == s"}
        ),
        "other_states": Mistake(
            "rows from other states are drawn, too. Both have to agree, s and a.", {THE_PAIR: "a_row == a"}
        ),
        "never_the_last": Mistake(
            "with n − 1 the last row is never drawn, for u stays below 1. Multiply by n.",
            {"u * len(seen)": "u * (len(seen) - 1)"},
        ),
        "rounds": Mistake(
            "round goes up as well as down, so the first and the last row come half as often as the others. "
            "int(u · n) gives each the same share.",
            {"int(u * len(seen))": "round(u * (len(seen) - 1))"},
        ),
        "first_row": Mistake("this is always the first row. Which one it is, u decides.", {DRAWN: "seen[0]"}),
        "last_row": Mistake("this is always the last row. Which one it is, u decides.", {DRAWN: "seen[-1]"}),
        "most_frequent": Mistake(
            "this is always the most frequent outcome. Then nothing is left to chance; u decides which one it is.",
            {DRAWN: "max(seen, key=seen.count)"},
        ),
        "each_outcome_once": Mistake(
            "every different outcome is equally probable here. One that was seen three times has to come three "
            "times as often: keep all its rows.",
            {DRAWN: "list(dict.fromkeys(seen))[int(u * len(set(seen)))]"},
        ),
        "state_of_the_row": Mistake(
            "this is the state that the row begins in. What comes next is its last number, s′.",
            {"(s_next, r) for": "(s_row, r) for"},
        ),
        "whole_row": Mistake(
            "this is the whole row. Return s′ and r alone.", {"(s_next, r) for": "(s_row, a_row, r, s_next) for"}
        ),
        "one_too_early": Mistake(
            "this is one row too early: int(u · n) is 0 for the first row.",
            {"int(u * len(seen))": "int(u * len(seen)) - 1"},
        ),
        "invents_an_outcome": Mistake(
            "a pair that was never tried has nothing to draw from: return None.", {"else None": "else (s, 0.0)"}
        ),
        "rows_that_end_in_s": Mistake(
            "a row belongs to the pair by the state it begins in, its first number; s′ is its last.",
            {THE_PAIR: "(s_next, a_row) == (s, a)"},
        ),
        "backwards": Mistake(
            "this counts from the last row back. Row number int(u · n) is counted from the first.",
            {DRAWN: "seen[-1 - int(u * len(seen))]"},
        ),
        "sorted": Mistake(
            "the rows are sorted first. Leave them in the order in which they were recorded.",
            {DRAWN: "sorted(seen)[int(u * len(seen))]"},
        ),
        "state_alone": Mistake("only s′ is here. The reward belongs to it.", {DRAWN: f"{DRAWN}[0]"}),
        "reward_alone": Mistake("only the reward is here. s′ stands before it.", {DRAWN: f"{DRAWN}[1]"}),
    },
    hints=(
        "First collect (s′, r) of all rows of the pair, in their order. Then take one of them by its number.",
        "A list: seen = [(s_next, r) for …, if state and action agree]. u · n lies between 0 and n, and int cuts off "
        "what comes after the point.",
        "return seen[int(u * len(seen))] if seen else None",
    ),
    gained="With this one function a list of rows becomes a world to learn in. Yours will be one in a moment.",
    witnesses=WITNESSES,
)
