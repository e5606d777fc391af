"""Right answers and tapes of lesson 18a; what is asked, hints and mistakes stand on the pages beside."""

from rlrobot_course.grading.parts import Question, with_pages

check = with_pages(
    globals(),
    who_stops=Question((3, 4, 1, 2, 4)),
)
