"""Right answers and tapes of lesson 16b; what is asked, hints and mistakes stand on the pages beside."""

from rlrobot_course.grading.page import with_pages
from rlrobot_course.grading.question import Question

two_biases = (((2 + 10) / 4 + 2 / 4) / 2, (3 * 2 + 1 * 10 + 3 * 2) / (3 + 1 + 3))
how_far = (0.0975 * (0.5 + 1) / 2, 0.0975 * (0 + 1) / 2)


check = with_pages(
    __file__,
    globals(),
    two_biases=Question(two_biases),
    how_far=Question(how_far),
)
