"""The formula behind a question in numbers tells by which change of it a wrong number comes about."""

from __future__ import annotations

import pytest

from rlrobot_grading.exercises.question import Question
from rlrobot_grading.hints.formula import Formula

SARSA = Formula(
    "Q + α * (r + γ * q - Q)", Q=4, α=0.2, r=10, γ=0.9, q=6, worst=-1, δ="r + γ * q - Q"
)
WRONG = {
    "stopped at “δ”": 11.4,
    "“γ” were left out of “γ * q”": 6.4,
    "“Q” were added to “r + γ * q”": 4 + 0.2 * (10 + 0.9 * 6 + 4),
    "“-1” stood in place of “q”": 4 + 0.2 * (10 + 0.9 * -1 - 4),
    "“α” and “γ” had changed places": 4 + 0.9 * (10 + 0.2 * 6 - 4),
    "the brackets around “r + γ * q - Q” were missing": 4 + 0.2 * 10 + 0.9 * 6 - 4,
    "a thousand times as much": 6280,
}


@pytest.mark.parametrize("said", WRONG)
def test_a_wrong_number_is_told_by_the_change_that_makes_it(said):
    verdict = Question(SARSA)(WRONG[said])
    assert said in verdict.hint and verdict.id == "formula"


def test_the_formula_gives_the_right_number_and_a_number_of_no_change_has_no_hint():
    question = Question(SARSA)
    assert question.right == pytest.approx(6.28) and question(6.28)
    assert not question(1234.5).hint


def test_of_a_number_that_many_changes_make_none_is_told():
    assert not Formula("2 * (a - b - c - d)", a=9, b=1, c=1, d=1).told(16, 1e-9)


def test_one_change_in_two_forms_is_told_once():
    assert (
        Formula("a * b", a=3.0, b=0.5).told(3.0, 1e-9)
        == "it is as if “b” were left out of “a * b”."
    )
