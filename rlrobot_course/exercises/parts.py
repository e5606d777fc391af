"""What the `exercises.py` of a lesson is made of, to be imported in one line."""

from rlrobot_course.exercises.design import Design as Design
from rlrobot_grading.answers.replay import Case as Case
from rlrobot_grading.exercises.exercise import Exercise as Exercise
from rlrobot_grading.exercises.mistake import Mistake as Mistake
from rlrobot_grading.exercises.mistake import wrong_choices as wrong_choices
from rlrobot_grading.exercises.page import with_pages as with_pages
from rlrobot_grading.exercises.question import Question as Question
from rlrobot_grading.hints.formula import Formula as Formula
