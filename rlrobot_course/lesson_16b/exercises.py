"""Right answers and tapes of lesson 16b; what is asked, hints and mistakes stand on the pages beside."""

from rlrobot_course.grading.formula import Formula
from rlrobot_course.grading.page import with_pages
from rlrobot_course.grading.question import Question

TWO_BIASES = Formula(
    "((Q + other) / members + Q / members) / 2, (2 * N * Q + N_other * other) / (2 * N + N_other)",
    Q=2, other=10, N=3, N_other=1, members=4,
)  # fmt: skip
two_biases = TWO_BIASES.value
HOW_FAR = Formula("(radius * (0.5 + 1) / 2, radius * (0 + 1) / 2)", radius=0.0975)
how_far = HOW_FAR.value


check = with_pages(
    globals(),
    two_biases=Question(TWO_BIASES),
    how_far=Question(HOW_FAR),
)
