"""How far a learner has come: what is kept and right counts, what was spoilt since then does not."""

from html import escape

import pytest

from rlrobot_course.learner import progress as progress_module
from rlrobot_course.learner.my_functions import FILE, keep
from rlrobot_course.learner.progress import progress, so_far
from rlrobot_course.lesson_03 import check, exercises
from rlrobot_edu.tools import commands


@pytest.fixture
def begun(tmp_path):
    """The folder of a learner with two functions of lesson 03."""
    for name in ("target", "update"):
        keep(getattr(exercises, name), "03", name, getattr(check, name).judge, tmp_path)
    return tmp_path


def test_it_tells_what_is_right_what_is_next_and_how_long_the_rest_takes(begun):
    lessons = {lesson.number: lesson for lesson in progress(begun).lessons}
    assert lessons["03"].right == ["target", "update"] and lessons["03"].write == [
        "learn"
    ]
    assert lessons["03"].minutes > 30 and lessons["01"].right == []
    assert "bin_of, state_number, reward" in progress(begun).next
    assert "00" not in lessons and "05a" not in lessons  # nothing is written there


def test_a_function_that_was_spoilt_in_the_file_counts_no_more(begun):
    text = (begun / FILE).read_text(encoding="utf-8")
    (begun / FILE).write_text(text.replace("gamma * ", ""), encoding="utf-8")
    lessons = {lesson.number: lesson for lesson in progress(begun).lessons}
    assert lessons["03"].right == []


def test_the_command_prints_a_table(begun, capsys):
    commands.main(["progress", str(begun)])
    out = capsys.readouterr().out
    assert "03  Q-learning" in out and "2 of 3" in out and "Next: lesson 01" in out


def test_a_beginner_is_told_where_to_begin_and_not_of_a_fault(tmp_path, capsys):
    commands.main(["progress", str(tmp_path)])
    said = capsys.readouterr().out
    assert "You have not begun yet" in said and "lab opens the course" in said
    assert "asks for the first function, bin_of." in said


def test_a_beginner_without_the_folder_is_told_the_same(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(progress_module, "FOLDER", tmp_path / "my_course")
    commands.main(["progress"])
    assert "You have not begun yet" in capsys.readouterr().out


def test_a_folder_that_is_not_there_is_named(tmp_path):
    with pytest.raises(SystemExit, match="nowhere: there is no such folder"):
        commands.main(["progress", str(tmp_path / "nowhere")])


def test_the_card_of_a_right_function_says_how_far_its_lesson_is(begun):
    assert so_far("03", begun) == "2 of 3 functions of this lesson are written."
    keep(exercises.learn, "03", "learn", check.learn.judge, begun)
    done = "That was the last function of lesson 03. Next on the road: lesson 04."
    assert so_far("03", begun) == done


def test_a_notebook_shows_a_road_with_a_stone_for_each_lesson(begun):
    keep(exercises.learn, "03", "learn", check.learn.judge, begun)
    road = progress(begun)
    page = road._repr_html_()
    assert page.count("<li ") == len(road.lessons)
    assert page.count("✓ done") == 1 and page.count("you are here") == 1
    assert "<b>01</b> States, actions, rewards<br><small>➤ you are here" in page
    assert escape(road.next) in page
