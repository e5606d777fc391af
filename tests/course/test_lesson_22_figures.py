"""Lesson 22's biases, those of the exercise and those of the library, are one."""

import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_22 import exercises
from rlrobot_course.lesson_22.figures import plot_blind
from rlrobot_course.lesson_22.vbiassr import VBIASSR
from rlrobot_edu.learning.size import Size


@pytest.mark.parametrize(
    ("selection", "bias"),
    list(zip(("QBIASSR", VBIASSR), exercises.two_biases, strict=True)),
)
def test_the_biases_of_the_example_are_those_of_the_library(selection, bias):
    agent = rl.Agent(Size((4, 4), 3), rl.Method("Q", selection))
    s, other = 5, 9  # bins (1, 1) and (2, 1)
    agent.q[[s, other], 0], agent.visits[[s, other], 0] = (2.0, 10.0), (3, 1)
    agent.begin_episode(s)
    assert agent.bias[0] == pytest.approx(bias)


def test_the_picture_of_the_blind_counts_those_that_earn_nearly_all():
    picture = plot_blind("blind", [3.0, 9.9, 9.6], most=10)
    assert picture.finding.startswith("2 of 3 robots that see nothing earn nearly 10")
    assert "blind: 3.0, 9.6, 9.9" in picture.alt
