"""Right answers and tapes of lesson 04b; what is asked, hints and mistakes stand on the pages beside."""

from rlrobot_course.grading.formula import Formula
from rlrobot_course.grading.page import with_pages
from rlrobot_course.grading.question import Question

FALL = Formula("1 - well ** steps", ε=0.1, actions=4, steps=11, p="ε / actions", well="1 - p")
fall = FALL.value


check = with_pages(
    globals(),
    fall=Question(FALL),
)
