"""Right answers and tapes of lesson 11a; what is asked, hints and mistakes stand on the pages beside."""

from rlrobot_course.grading.parts import Formula, Question, with_pages

STILL_SAFE = Formula("margin + way", margin=0.05, radius=0.0975, speed=2, single_speed=1, way="speed * radius")

check = with_pages(
    globals(),
    still_safe=Question(STILL_SAFE),
)
