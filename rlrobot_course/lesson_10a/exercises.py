"""Right answers and tapes of lesson 10a; what is asked, hints and mistakes stand on the pages beside."""

from rlrobot_course.grading.page import with_pages
from rlrobot_course.grading.question import Question

still_safe = 0.05 + 2 * 0.0975


check = with_pages(
    __file__,
    globals(),
    still_safe=Question(still_safe),
)
