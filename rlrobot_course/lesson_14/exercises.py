"""Right answers and tapes of lesson 14; the pages of this folder have the tasks, hints and mistakes."""

from rlrobot_course.exercises.parts import (
    Case,
    Exercise,
    Formula,
    Question,
    with_pages,
)


def estimate(rows, s, a):
    rewards = {}
    for s_row, a_row, r, s_next in rows:
        if (s_row, a_row) == (s, a):
            rewards.setdefault(s_next, []).append(r)
    n = sum(len(seen) for seen in rewards.values())
    return {
        s_next: (len(seen) / n, sum(seen) / len(seen))
        for s_next, seen in rewards.items()
    }


# (s, a, r, s'): the pair (0, 1) leads to state 1 four times, to 2 twice and to 0 once; (2, 0) was seen only once
ROWS = [
    (0, 1, -2.0, 1),
    (1, 1, 10.0, 0),
    (0, 1, 10.0, 1),
    (0, 0, -0.02, 2),
    (2, 0, 10.0, 3),
    (0, 1, -0.02, 2),
    (0, 1, 10.0, 1),
    (3, 1, -2.0, 1),
    (1, 1, -0.02, 3),
    (0, 1, 10.0, 0),
    (0, 1, -0.02, 1),
    (0, 0, 10.0, 0),
    (1, 0, -2.0, 0),
    (0, 1, 10.0, 2),
    (1, 1, 10.0, 0),
    (3, 1, -2.0, 1),
]
# rewards with many digits
FINE_ROWS = [(1, 0, 1.23456, 2), (1, 0, -0.98765, 0), (1, 0, 3.14159, 2)]
ASKED = [(0, 1), (1, 1), (0, 0), (2, 0), (3, 1), (2, 1)]


class OfRows(Exercise):
    """The whole table is long; what counts of it is shown, the rows of the pair."""

    def _called(self, case: Case) -> str:
        rows = ", ".join(
            str(row) for row in case["rows"] if row[:2] == (case["s"], case["a"])
        )
        return f"s = {case['s']}, a = {case['a']}; rows of this pair: {rows}; and {len(case['rows'])} rows in all"


def sample(rows, s, a, u):
    seen = [(s_next, r) for s_row, a_row, r, s_next in rows if (s_row, a_row) == (s, a)]
    return seen[int(u * len(seen))] if seen else None


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
    (0, 1, 0.42851),  # just below, and just above, three sevenths
    (0, 1, 0.42862),
    (0, 1, 0.99999),
]

SECOND_LOOK = Formula(
    "paid / (1 - p * γ)", p=0.5, γ=0.9, r_of_the_loop=10, r_away=-0.02, value_there=40, away="r_away + γ * value_there",
    paid="p * r_of_the_loop + p * away",
)  # fmt: skip

check = with_pages(
    globals(),
    estimate=OfRows(
        estimate,
        returns="estimate",
        tape=[{"rows": ROWS, "s": s, "a": a} for s, a in ASKED]
        + [{"rows": FINE_ROWS, "s": 1, "a": 0}],
    ),
    second_look=Question(SECOND_LOOK),
    sample=Exercise(
        sample,
        returns="outcome",
        tape=[{"rows": ROWS, "s": s, "a": a, "u": u} for s, a, u in DRAWS]
        + [{"rows": FINE_ROWS, "s": 1, "a": 0, "u": 0.67432}],
    ),
)
