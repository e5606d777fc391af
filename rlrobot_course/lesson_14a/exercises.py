"""Right answers and tapes of lesson 14a; what is asked, hints and mistakes stand on the pages beside."""

from rlrobot_course.grading.parts import Formula, Question, with_pages

SECOND_LOOK = Formula(
    "paid / (1 - p * γ)", p=0.5, γ=0.9, r_of_the_loop=10, r_away=-0.02, V=40, away="r_away + γ * V",
    paid="p * r_of_the_loop + p * away",
)  # fmt: skip

check = with_pages(
    globals(),
    second_look=Question(SECOND_LOOK),
)
