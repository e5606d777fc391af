"""Right answers and tapes of lesson 22; the pages of this folder have the tasks, hints and mistakes."""

from rlrobot_course.exercises.parts import Formula, Question, with_pages

TWO_BIASES = Formula(
    "((Q + other) / members + Q / members) / 2, (2 * N * Q + N_other * other) / (2 * N + N_other)",
    Q=2, other=10, N=3, N_other=1, members=4,
)  # fmt: skip

check = with_pages(
    globals(),
    two_biases=Question(TWO_BIASES),
    how_far=Question(
        Formula("(radius * (0.5 + 1) / 2, radius * (0 + 1) / 2)", radius=0.0975)
    ),
)
