"""The right answer of lesson 08b; what is asked, hints and mistakes stand on the page beside."""

from rlrobot_course.grading.parts import Formula, Question, with_pages

check = with_pages(globals(), bump_share=Question(Formula("α * e * r", α=0.5, e=4.47, r=-2, Q=-94.6)))
