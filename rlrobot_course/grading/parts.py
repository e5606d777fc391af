"""What the `exercises.py` of a lesson is made of, to be imported in one line."""

from rlrobot_course.grading.design import Design as Design
from rlrobot_course.grading.exercise import Exercise as Exercise
from rlrobot_course.grading.formula import Formula as Formula
from rlrobot_course.grading.mistake import Mistake as Mistake
from rlrobot_course.grading.mistake import wrong_choices as wrong_choices
from rlrobot_course.grading.page import with_pages as with_pages
from rlrobot_course.grading.question import Question as Question
from rlrobot_course.grading.replay import Case as Case
