"""Right answers and tapes of lesson 06b; what is asked, hints and mistakes stand on the pages beside."""

from rlrobot_course.grading.parts import Formula, Question, with_pages

FALL = Formula("1 - well ** steps", ε=0.1, actions=4, steps=11, p="ε / actions", well="1 - p")

check = with_pages(
    globals(),
    fall=Question(FALL),
)
