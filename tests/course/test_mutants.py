"""The tapes separate: whatever one thing is different in a right answer, some case shows it, or it is right, too."""

import inspect
import re
import textwrap

import numpy as np
import pytest
from test_checks import EVERY, exercises

from rlrobot_course.lesson_14.exercises import OfRows
from rlrobot_grading.answers.source import parameters
from rlrobot_grading.exercises.exercise import Exercise
from rlrobot_grading.hints.changed import changed, made
from rlrobot_grading.hints.simple_changes import simple_changes

FRESH = "with a fresh trace of 1 the two terms with q_old cancel"
AS_LONG = "both are of one length"
SUM = "two sums into one array, in any order"

# by exercise, what is another text and yet right, and why
RIGHT_TOO = {
    ("assignment_1", "returns"): {
        "1.0 stood in place of 0.0": "a place that is written to later",
        "-1.0 stood in place of 0.0": "likewise",
        "“ends” stood in place of “rewards”": AS_LONG,
    },
    ("assignment_3", "true_online_episode"): {
        "1 stood in place of 0": FRESH,
        "-1 stood in place of 0": FRESH,
        "“v[s] -= alpha * (v_s - v_old)” came before “v += alpha * (delta + v_s - v_old) * e”": SUM,
    },
    ("assignment_4", "drive"): {
        "9 stood in place of 8": "of the rewards the last four at most are asked for",
        "7 stood in place of 8": "likewise",
    },
    ("assignment_4", "near_states"): {
        "“step” were taken off “other[i]”, not added": "steps are −1 and 1",
        "“is_circle” stood in place of “shape”": AS_LONG,
        "“shape” stood in place of “s”": "an input has two bins or more, so no step leads back to s",
        "“is_circle” stood in place of “s”": "likewise",
    },
    ("assignment_4", "next_temperature"): {
        "“rewards” stood in place of “states”": AS_LONG
    },
    ("assignment_4", "period"): {
        "0 stood in place of 1": "the last none are like the none before them only in an empty list, whose period is 0",
        "1 stood in place of 2": "there are not twice so many states: the slices differ in length",
    },
    ("assignment_5", "verdict"): {
        "“if high < 0:” came before “if low > 0:”": "low is below high"
    },
    ("lesson_08", "true_online_update"): {
        "“q[s, a] -= alpha * (q_sa - q_old)” came before “q += alpha * (delta + q_sa - q_old) * e”": SUM,
    },
    ("lesson_09", "new_temperature"): {
        "1.04 stood in place of 1": "a count is whole",
        "“states” stood in place of “rewards”": AS_LONG,
        **dict.fromkeys(
            (
                "“sum(rewards)” were multiplied by “len(rewards)”, not divided",
                "“sum(rewards)” / “len(rewards)” were rounded down, as by //",
                "“len(rewards)” were one less",
            ),
            "only the sign of the mean is asked for",
        ),
    },
    ("lesson_10", "learn"): {
        "1.0 stood in place of 0.0": FRESH,
        "-1.0 stood in place of 0.0": FRESH,
    },
    ("lesson_10", "learn_and_evade"): {
        "1.0 stood in place of 0.0": FRESH,
        "-1.0 stood in place of 0.0": FRESH,
    },
    ("lesson_17", "dyna"): {
        "“seen[s, a] = (r, s_next, terminated)” came before “update(q, s, a, r, s_next, terminated)”": "as good",
    },
    ("lesson_18", "allowed"): {"“v >= 0” were asked, not “v > 0”": "a v of 0 stays 0"},
    ("lesson_18", "nearest_ahead"): {
        "“math.cos(angle) > 0.5” were asked, not “math.cos(angle) >= 0.5”": "no angle has a cosine of exactly 0.5"
    },
}


def mutants(right):
    """Each function that differs from `right` by one simple change, after what is different in words."""
    source = textwrap.dedent(inspect.getsource(right))
    return (
        (said, made(tree, right))
        for said, tree in changed(source, parameters(right), simple_changes)
    )


def survivors(exercise: Exercise) -> list[str]:
    """What is different in the mutants that do in every case what is right.

    No mutant needs a time limit, because `made` ends its loops. With one, the mutants take twice as long.
    """
    with np.errstate(all="ignore"):
        return [
            re.split(" in “|: “", said)[0]
            for said, mutant in mutants(exercise.right)
            if all(
                map(
                    lambda right, case: right.equals(
                        exercise.outcome(mutant, case, endless=True)
                    ),
                    exercise.expected,
                    exercise.cases,
                )
            )
        ]


@pytest.mark.long
@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize(
    ("lesson", "name"),
    [one for one in EVERY if type(exercises(one[0])[one[1]]) in (Exercise, OfRows)],
)
def test_a_mutant_differs_in_some_case_unless_it_is_right_too(lesson, name):
    """Not of questions, nor of designs, where many answers are right."""
    assert set(survivors(exercises(lesson)[name])) == set(
        RIGHT_TOO.get((lesson, name), ())
    )


def test_what_occurs_twice_in_the_code_around_it_is_told_with_the_whole_of_it():
    def right(x):
        return x ** (x + 1) + 1

    told = "0 stood in place of 1: “x ** (x + 1) + 0”, not “x ** (x + 1) + 1”"
    assert dict(mutants(right))[told](2) == 8


def test_mutants_differ_in_one_thing_and_say_which():
    def right(x, y):
        if x > 1:
            return x + 2 * y
        return max(y, 0.5)

    said = dict(mutants(right))
    assert len(said) > 20 and said["“x >= 1” were asked, not “x > 1”"](1, 3) == 7
    assert said["“2” were divided by “y”, not multiplied"](4, 2) == 5
    assert said["“x > 1” never held"](9, 3) == 3
    assert said["“min” stood in place of “max” in “max(y, 0.5)”"](0, 3) == 0.5
