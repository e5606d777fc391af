"""What the `exercises.py` of a lesson is made of, to be imported in one line."""

from rlrobot_grading.design import Design as Design
from rlrobot_grading.exercise import Exercise as Exercise
from rlrobot_grading.formula import Formula as Formula
from rlrobot_grading.mistake import Mistake as Mistake
from rlrobot_grading.mistake import wrong_choices as wrong_choices
from rlrobot_grading.page import with_pages as with_pages
from rlrobot_grading.question import Question as Question
from rlrobot_grading.replay import Case as Case
