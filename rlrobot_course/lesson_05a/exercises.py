"""Right answers and tapes of lesson 05a; what is asked, hints and mistakes stand on the pages beside."""

from rlrobot_course.grading.parts import Question, with_pages

best_adviser = "floor"

check = with_pages(
    globals(),
    best_adviser=Question(best_adviser),
)
