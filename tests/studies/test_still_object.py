"""The study of inputs that never change: its page follows from its numbers, and the numbers from the tasks."""

import json

import pytest
import still_object as study
from scipy import stats
from test_headlines import ROOT, tells

import rlrobot_edu as rl


@pytest.fixture(scope="module")
def found():
    return json.loads(study.FILE.read_text(encoding="utf-8"))


def test_the_page_is_what_its_numbers_say(found):
    page = ROOT / "docs/studies/still_object.md"
    assert page.read_text(encoding="utf-8") == study.page(found)


def test_methods_that_look_at_one_state_earn_the_same_without_the_object(found):
    """In arm_4k; in arm_1k the queue of loop evasion is shorter."""
    its = found["arm_4k"]
    for episodes, finals in its["as it is"].items():
        other = its["without the object"][episodes]
        assert all(finals[label] == other[label] for label in ("TOSL+SR", "Q+SR"))
        assert finals["TOSL+QBIASSR"] != other["TOSL+QBIASSR"]


def test_the_states_that_occur_are_those_of_the_gripper_with_one_place_of_the_object(
    found,
):
    for name, its in found.items():
        small = study.without_object(rl.load_task(name))
        assert its["states without the object"] == small.states.n
        assert (
            its["met"] <= small.states.n < its["states"] == rl.load_task(name).states.n
        )


def test_the_page_of_results_tells_how_many_states_occur(found):
    numbers = [
        number for its in found.values() for number in (its["met"], its["states"])
    ]
    assert tells("docs/results.md", *numbers)


def test_the_change_is_less_than_the_intervals_show(found):
    halves = []
    for its in found.values():
        for finals in its["as it is"].values():
            test = stats.ttest_ind(
                finals["TOSL+QBIASSR"], finals["TOSL+SR"], equal_var=False
            )
            low, high = test.confidence_interval()
            halves.append((high - low) / 2)
    assert study.largest_change(found) < min(halves)
