"""Right answers and tapes of lesson 21; the pages of this folder have the tasks, hints and mistakes."""

from rlrobot_course.exercises.parts import Exercise, with_pages
from rlrobot_course.worlds.tapes import rows


def overlaps(left, right, edges):
    shares = []
    for i in range(len(edges) - 1):
        low, high = edges[i], edges[i + 1]
        common = min(right, high) - max(left, low)
        shares.append(max(0, common) / (right - left))
    return shares


PIONEER, GIRAFF = [0.0, 0.27, 0.53, 0.80, 5.0], [0.0, 0.08, 0.17, 0.25, 5.0]


check = with_pages(
    globals(),
    overlaps=Exercise(
        overlaps,
        returns="shares",
        tape=rows(
            "left right edges",
            (0.2, 0.4, PIONEER),
            (0.0, 0.2, PIONEER),
            (0.08, 0.17, PIONEER),
            (0.6, 0.8, PIONEER),
            (0.25, 5.0, PIONEER),
            (0.27, 0.53, GIRAFF),
            (0.5, 1.5, [0.0, 1.0, 2.0]),
            (0.27, 0.53, PIONEER),
            (0.1, 0.9, PIONEER),
            (2.0, 6.0, [0.0, 1.0, 3.0, 4.0, 8.0]),
            (4.0, 6.0, PIONEER),  # a laser that sees further than 5 m
            (0.12345, 0.65432, [0.0, 0.27004, 0.53107, 0.80009, 5.0]),
        ),
    ),
)
