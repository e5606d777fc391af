"""Right answers and tapes of lesson 15; the pages of this folder have the tasks, hints and mistakes."""

from rlrobot_course.exercises.parts import Exercise, Formula, Question, with_pages
from rlrobot_course.worlds.tapes import rows

AGENTS_NEEDED = Formula(
    "2 * (SD / error) ** 2", SD=3, difference=0.5, error="difference / 3"
)


def p_value(observed, shuffled):
    return sum(f >= observed for f in shuffled) / len(shuffled)


check = with_pages(
    globals(),
    agents_needed=Question(AGENTS_NEEDED),
    p_value=Exercise(
        p_value,
        returns="p",
        tape=rows(
            "observed shuffled[]",
            (3.0, [0.2, 1.1, 3.0, 0.7, 5.2, 0.1, 0.4, 2.9, 0.6, 3.0, 1.5]),
            (26.0, [0.5, 1.5, 2.5, 0.1]),
            (0.5, [0.5, 1.5, 2.5, 0.1, 0.9, 0.3, 0.2]),
            (0.05, [0.7, 1.5, 2.5]),
            (2.0, [2.0, 0.4, 0.1, 0.3, 0.8, 1.2, 0.0, 1.9, 0.6, 0.5, 0.2, 0.9, 1.1]),
            (1.00043, [1.0, 1.00046, 0.9, 0.7, 1.00041, 0.3, 1.5]),
            (2.0, [1.99958, 0.9, 1.1]),
        ),
    ),
)
