"""Right answers and tapes of lesson 10a; what is asked, hints and mistakes stand on the pages beside."""

from rlrobot_course.grading.formula import Formula
from rlrobot_course.grading.page import with_pages
from rlrobot_course.grading.question import Question

STILL_SAFE = Formula("margin + way", margin=0.05, radius=0.0975, speed=2, single_speed=1, way="speed * radius")
still_safe = STILL_SAFE.value


check = with_pages(
    globals(),
    still_safe=Question(STILL_SAFE),
)
