"""What the exercises of lesson 13 share."""

from __future__ import annotations

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

THE_PAIR = "(s_row, a_row) == (s, a)"
