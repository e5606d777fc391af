"""Right answers and tapes of lesson 03a; what is asked, hints and mistakes stand on the pages beside."""

from rlrobot_course.grading.parts import Formula, Question, with_pages

check = with_pages(
    globals(),
    look_ahead=Question(Formula("half ** (1 / steps)", half=0.5, steps=10)),
)
