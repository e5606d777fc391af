"""The learner's own thread: their rows, their model, their robot over a link, from an empty folder to the last page."""

import csv
import re

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.thread.last_page import (
    compared,
    difference,
    keep_page,
    plot_numbers,
    sentence,
)
from rlrobot_course.thread.not_known import (
    not_known_finding,
    places,
    plot_not_known,
)
from rlrobot_course.thread.numbers import learned, measured, signed
from rlrobot_course.thread.rows import STAND_IN, my_robot, my_rows
from rlrobot_edu.models.diagnosis import Loop
from rlrobot_edu.widgets.driving.keys import keys_of
from rlrobot_edu.widgets.driving.pad import Pad

LASERS = ["laser_front_left", "laser_front", "laser_front_right"]


@pytest.fixture
def here(tmp_path, monkeypatch):
    """An empty folder beside the lessons."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def robot(here):
    return my_robot()


def driven(robot, steps=120):
    """A pad on which arrow keys have been pressed at random, by the clicks that the keys of the page make."""
    task = rl.load_task(robot)
    keys = keys_of(task)
    arrows = [keys[f"Arrow{way}"] for way in ("Up", "Up", "Left", "Right", "Down")]
    pad = Pad(rl.make_env(task, seed=0))
    buttons = {}
    todo = [pad.widget]
    while todo:
        widget = todo.pop()
        todo += getattr(widget, "children", ())
        for name in getattr(widget, "_dom_classes", ()):
            buttons[name] = widget
    for a in np.random.default_rng(0).choice(arrows, steps).tolist():
        buttons[f"rl-action-{a}"].click()
    return pad


def numbers_of(rows, robot):
    agent, model = learned(rows)
    there = {"promised": rl.make_env(model, seed=1), "simulated": rl.make_env(robot, seed=1)}  # fmt: skip
    return agent, {name: measured(agent, env) for name, env in there.items()}


def test_the_task_file_is_written_once_and_never_overwritten(here):
    path = my_robot()
    assert path.relative_to(path.parents[1]).as_posix() == "my_robot/my_robot.py"
    assert rl.load_task(path).name == "my_robot"
    path.write_text(path.read_text("utf-8") + "# mine\n", "utf-8")
    assert my_robot().read_text("utf-8").endswith("# mine\n")


def test_a_stand_in_drives_where_nobody_has_and_says_so(robot, capsys):
    rows = my_rows(robot, Pad(rl.make_env(robot, seed=0)))
    assert len(rows) == STAND_IN
    assert "rows are not yours" in capsys.readouterr().out
    assert not (robot.parent / "rows").exists()


def test_keys_make_rows_that_later_lessons_take_from_the_folder(robot, capsys):
    pad = driven(robot)
    rows = my_rows(robot, pad)
    assert rows.a.tolist() == pad.recording.a.tolist()
    again = my_rows(robot)
    assert "yours: 120 steps, kept" in capsys.readouterr().out
    for column in ("s", "a", "r", "s_next"):
        assert getattr(again, column).tolist() == getattr(rows, column).tolist()
    few = my_rows(robot, driven(robot, steps=3))
    assert "You drove 3 steps; 100 are needed." in capsys.readouterr().out
    assert len(few) == 120, "those kept before"


def test_the_same_buttons_serve_a_task_that_senses_and_pays_something_else(robot):
    rows = my_rows(robot, driven(robot))
    text = robot.read_text("utf-8")
    text = text.replace("cuts=[0.30]", "cuts=[0.30, 0.60]").replace("-0.02", "-0.5")
    robot.write_text(text, "utf-8")
    changed = my_rows(robot)
    assert changed.a.tolist() == rows.a.tolist()
    assert changed.source.states.n == 27 and -0.5 in changed.r
    assert places(changed)[0] == pytest.approx(places(rows)[0])


def test_other_actions_need_a_new_drive(robot, capsys):
    my_rows(robot, driven(robot))
    text = robot.read_text("utf-8").replace("values=[-1, 1]", "values=[-1, 0, 1]")
    robot.write_text(text, "utf-8")
    assert len(my_rows(robot)) == STAND_IN
    assert "your task has other actions now" in capsys.readouterr().out


def test_a_csv_file_goes_all_the_way(robot, capsys):
    pad = driven(robot, steps=150)
    its = pad.recording
    with open("mine.csv", "w", newline="", encoding="utf-8") as file:
        rows = zip(its.s, its.a, its.r, its.s_next, strict=True)
        csv.writer(file).writerows([("s", "a", "r", "s_next"), *rows])
    rows = my_rows(robot, "mine.csv")
    assert "yours: 150 steps" in capsys.readouterr().out
    assert my_rows(robot).r.tolist() == rows.r.tolist()
    found = numbers_of(rows, robot)[1]
    found["driven"] = found["simulated"] - 1
    keep_page(found, rows)
    page = (robot.parent / "my_robot.html").read_text("utf-8")
    assert "It learned from 150 rows that you gave" in page
    for values in found.values():
        assert f"<td>{signed(values.mean())} ± " in page
    robot.write_text(robot.read_text("utf-8").replace("0.30]", "0.30, 0.60]"), "utf-8")
    assert len(my_rows(robot)) == STAND_IN
    assert "Your rows are left aside" in capsys.readouterr().out


def test_a_recording_of_ones_own_rows_is_taken_and_one_of_another_task_is_not(robot):
    its = driven(robot).recording
    columns = (its.s.tolist(), its.a.tolist(), its.r.tolist(), its.s_next.tolist())
    own = rl.Recording.from_rows(list(zip(*columns, strict=True)), robot)
    assert my_rows(robot, own).r.tolist() == columns[2]
    with pytest.raises(ValueError, match="of wander_1k, not of your task my_robot"):
        my_rows(robot, rl.read_recording("wander_1k"))
    assert my_rows(robot).s.tolist() == columns[0]


def test_rows_of_another_task_are_refused_and_what_was_kept_stays(robot):
    my_rows(robot, driven(robot))
    with pytest.raises(ValueError, match="my_robot"):
        my_rows(robot, [(99, 0, 10, 0)])
    assert len(my_rows(robot)) == 120


def test_damaged_rows_are_left_aside_and_not_lost(robot, capsys):
    my_rows(robot, driven(robot))
    file = robot.parent / "rows" / "transitions.csv"
    file.write_text("no rows\n", "utf-8")
    assert len(my_rows(robot)) == STAND_IN
    assert "Your rows are left aside" in capsys.readouterr().out
    assert file.read_text("utf-8") == "no rows\n"


def test_the_page_of_what_is_not_known_says_what_the_model_says_of_itself(robot):
    rows = my_rows(robot)
    diagnosis = rl.SampleModel.from_recording(rows).diagnose()
    held = rl.SampleModel.hold_back(rows)
    picture = plot_not_known(rows)
    never = diagnosis.n_pairs - diagnosis.pairs_seen
    assert f"{never} of {diagnosis.n_pairs} pairs were never tried" in picture.finding
    assert held.verdict in picture.alt and "A map" in picture.alt
    sure = held._replace(gained_by_chance=1.0)
    loop = Loop(states=(5,), pairs=((5, 0),), reward=1.0, samples=1)
    one, none = (diagnosis._replace(loops=loops) for loops in ((loop,), ()))
    assert "1 suspect loop rests on a few rows" in not_known_finding(one, sure)
    assert "nothing else is shown" in not_known_finding(none, sure)


def test_rows_that_no_simulator_made_have_no_map(robot):
    rows = my_rows(robot, [(7, 3, 10, 0), (0, 1, -2, 7)] * 60)
    assert places(rows) == []
    assert "No map" in plot_not_known(rows).alt


def test_the_same_rows_make_the_same_agent_and_it_does_not_learn_when_measured(robot):
    rows = my_rows(robot)
    (one, found), (other, again) = (numbers_of(rows, robot) for _ in range(2))
    np.testing.assert_array_equal(one.q, other.q)
    for name, values in found.items():
        assert values.tolist() == again[name].tolist() and values.shape == (10,)


def test_the_sentence_says_more_less_or_not_shown():
    low = np.array([1.0, 1.1] * 5)
    found = {"promised": low + 5, "simulated": low, "driven": low + 0.01}
    said = sentence(found)
    assert said.startswith("Promised is more than simulated, by 5.0 ± 0.1; ")
    assert "simulated and driven are not shown to differ (0.0 ± 0.1)" in said
    assert compared(found, "simulated", "promised").endswith("by 5.0 ± 0.1")
    by, half = difference(low + 5, low)
    assert by == pytest.approx(5) and 0 < half < 0.1
    picture = plot_numbers(found)
    assert picture.finding == "Your robot: promised 6.0; simulated 1.0; driven 1.1"


def test_the_agent_of_the_stand_in_drives_over_the_link_and_the_page_is_kept(
    robot, nothing_is_left_running, capsys
):
    pytest.importorskip("websockets")
    from rlrobot_ros import RobotLink, ServedRobot

    rows = my_rows(robot)
    agent, found = numbers_of(rows, robot)
    with ServedRobot(robot, seed=0, port=0, simulated_time=True) as body:
        link = RobotLink(body.address, confirmed=True, simulated_time=True)
        env = rl.make_env(robot, link=link, seed=1)
        found["driven"] = measured(agent, env)
        env.close()
    keep_page(found, rows)
    page = (robot.parent / "my_robot.html").read_text("utf-8")
    assert "a stand-in that drove at random" in page and sentence(found) in page
    assert re.search(r'<img alt="[^"]{50,}"', page)
    assert found["driven"].mean() > 3, "a rehearsal that nobody enjoys teaches nothing"
    assert "my_robot/my_robot.html" in capsys.readouterr().out
