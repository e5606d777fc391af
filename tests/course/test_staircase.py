"""The staircase: robots, means and intervals of the lessons so far, and a place for each lesson to come."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.colors import to_hex

from rlrobot_course.play.challenge import Score
from rlrobot_course.play.scoreboard import library_stairs
from rlrobot_course.play.staircase import SIDES, Stair, plot_stairs, sides
from rlrobot_edu.show.palette import BLUE, GREY

LABELS = {lesson: stair.label for lesson, stair in library_stairs().items()}


def stair(mean, half=0.1, owner="the given", spread=(-0.5, 0.0, 0.5)):
    """A stair whose robots lie so far from their mean."""
    each = tuple(mean + x for x in spread)
    return Stair("at random", Score(mean, half), owner, each)


def drawn(stairs):
    picture = plot_stairs(stairs, LABELS)
    return picture, picture.axes[0]


def texts(ax):
    return [text.get_text() for text in ax.texts]


def dots(ax):
    """The lines of dots, one a stair, from left to right."""
    return [line for line in ax.lines if line.get_marker() == "o"]


def risers(ax):
    """The lines from stair to stair, which alone have a corner."""
    lines = [line for line in ax.lines if line.get_marker() == "None"]
    return [line for line in lines if len(line.get_xdata()) == 3]


def test_every_robot_is_a_dot_at_its_reward_near_its_stair():
    _, ax = drawn({"03": stair(0.5), "04": stair(2.0)})
    for at, (line, mean) in enumerate(zip(dots(ax), (0.5, 2.0), strict=True)):
        assert list(line.get_ydata()) == [mean - 0.5, mean, mean + 0.5]
        assert np.abs(line.get_xdata() - at).max() < 0.5


def test_the_mean_of_each_stair_is_written_above_it_and_lessons_to_come_have_a_sign():
    _, ax = drawn({"03": stair(-0.25), "04": stair(2.0)})
    said = texts(ax)
    assert "−0.25" in said and "2.00" in said
    assert said.count("?") == len(LABELS) - 2
    assert set(LABELS) <= set(said)


def test_owners_are_told_apart_without_colours():
    stairs = {"03": stair(1), "04": stair(2, owner="partly your")}
    picture, ax = drawn({**stairs, "05": stair(3, owner="your")})
    given, partly, own = dots(ax)
    assert [to_hex(line.get_color()) for line in (given, partly, own)] == [
        GREY,
        BLUE,
        BLUE,
    ]
    insides = {to_hex(line.get_markerfacecolor()) for line in (given, partly, own)}
    assert len(insides) == 3  # the partly own are rings
    note = picture.texts[-1].get_text()
    for said in ("Grey: given", "Rings: partly yours", "Blue: your functions"):
        assert said in note


def test_the_note_says_nothing_of_looks_that_are_not_there():
    picture, _ = drawn({"03": stair(1)})
    note = picture.texts[-1].get_text()
    assert "Blue" not in note and "Rings" not in note and "Dashed" not in note
    assert "3 robots" in note


@pytest.mark.parametrize("more, style", [(0.2, "--"), (-0.2, "--"), (0.3, "-"), (-0.3, "-")])  # fmt: skip
def test_a_riser_is_dashed_if_the_difference_may_be_chance(more, style):
    """Two intervals of ± 0.2 make ± 0.28 of their difference."""
    picture, ax = drawn({"03": stair(1, 0.2), "04": stair(1 + more, 0.2)})
    (riser,) = risers(ax)
    assert riser.get_linestyle() == style
    assert list(riser.get_ydata()) == [1, 1, 1 + more]
    assert ("may be chance" in picture.finding) == (style == "--")
    assert ("Dashed" in picture.texts[-1].get_text()) == (style == "--")
    assert ("may be chance" in picture.alt) == (style == "--")


def test_lesson_06_climbs_from_lesson_04():
    heights = {"03": 0.5, "04": 1.0, "05": 4.0, "06": 2.0}
    picture, ax = drawn({lesson: stair(x) for lesson, x in heights.items()})
    assert [line.get_ydata()[0] for line in risers(ax)] == [0.5, 1.0, 1.0]
    assert picture.finding == "The robot earns 2.00 a step, 1.00 more than in lesson 04"


def test_the_title_is_what_the_latest_lesson_changed():
    first, _ = drawn({"03": stair(1, owner="your")})
    assert first.finding == "Your robot earns 1.00 a step at random"
    less, _ = drawn({"03": stair(1), "04": stair(-1, owner="partly your")})
    assert less.finding == "Your robot earns −1.00 a step, 2.00 less than in lesson 03"
    last, _ = drawn({lesson: stair(0.5 * n) for n, lesson in enumerate(LABELS)})
    assert last.finding.endswith(
        "0.50 more than in lesson 09, 3.50 more than in lesson 03"
    )


def test_a_stair_whose_robots_were_not_kept_has_its_mean_and_interval():
    bare = Stair("softmax", Score(2.0, 0.3), "your")
    picture, ax = drawn({"03": stair(1), "04": bare})
    assert "2.00" in texts(ax)
    assert [len(line.get_xdata()) for line in dots(ax)] == [3, 0]
    assert "softmax: 2.00 ± 0.30 (your functions)" in picture.alt


def test_all_lessons_have_the_same_axes_and_higher_ones_if_need_be():
    _, usual = drawn({"03": stair(0.5)})
    _, later = drawn({"03": stair(0.5), "04": stair(4)})
    assert usual.get_ylim() == later.get_ylim()
    _, higher = drawn({"03": stair(-3), "04": stair(9)})
    low, high = higher.get_ylim()
    assert low <= -3.5 and high > 9.5


@given(st.lists(st.floats(-5, 9), max_size=len(SIDES)), st.floats(0.01, 1))
def test_no_dot_hides_another(heights, tall):
    chosen = sides(heights, tall)
    places = list(zip(chosen, heights, strict=True))
    for i, (side, height) in enumerate(places):
        for other, its in places[:i]:
            assert side != other or abs(height - its) >= tall


def test_more_dots_of_one_height_than_there_are_sides_are_drawn_too():
    assert len(sides([1.0] * 16, 0.1)) == 16
