"""Right answers and tapes of lesson 04b; what is asked, hints and mistakes stand on the pages beside."""

from rlrobot_course.grading.page import with_pages
from rlrobot_course.grading.question import Question

fall = 1 - (1 - 0.1 / 4) ** 11


check = with_pages(
    __file__,
    globals(),
    fall=Question(fall),
)
