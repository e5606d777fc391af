"""A red card offers to show what the robot does by the learner's code; whatever that is, there is something to show."""

import importlib
import math
import time
from pathlib import Path

import ipywidgets
import numpy as np
import pytest

from rlrobot_course.drives import beside as sides
from rlrobot_course.drives import by_your_code
from rlrobot_course.drives.beside import ALIKE, NOTHING, are_alike, beside
from rlrobot_course.drives.button import ASKS, FAILS, DriveButton
from rlrobot_course.drives.by_your_code import FILMED, SECONDS, drive_of
from rlrobot_course.exercises.parts import _offered
from rlrobot_grading.exercises import exercise as exercises
from rlrobot_grading.exercises.verdict import Verdict

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"

DRIVEN = [
    ("01", "reward"),
    ("03", "target"),
    ("03", "update"),
    ("03", "learn"),
    ("04", "draw"),
    ("08", "dutch"),
    ("10", "choose"),
    ("10", "learn"),
    ("10", "learn_and_evade"),
    ("13", "arm_reward"),
    ("16", "follow_reward"),
]
AT_MOST = 4 * SECONDS  # both drives on a busy machine; a call that ends late adds to it


def of(lesson, name):
    return getattr(importlib.import_module(f"rlrobot_course.lesson_{lesson}").check, name)  # fmt: skip


def tried(lesson, name, answer):
    exercise = of(lesson, name)
    assert not exercise.judge(answer), "only what is wrong has a button"
    begin = time.process_time()
    found = beside(drive_of(exercise), exercise.right, answer)
    took = time.process_time() - begin
    assert took < AT_MOST
    return found


@pytest.fixture(autouse=True, scope="module")
def compiled():
    """The right drives, so that no test waits for a compiler."""
    for lesson, name in DRIVEN:
        exercise = of(lesson, name)
        sides.by_right(drive_of(exercise), exercise.right)


def pays_to_stand(before, after):
    moved = math.hypot(after["x"] - before["x"], after["y"] - before["y"])
    return 5 if moved < 0.01 else -1


def is_not_a_number(*given):
    return math.nan


def says_much(*given):
    print("much " * 1000)
    return "much"


def returns_nothing(*given):
    return None


def is_infinite(*given):
    return 10**400


def never_ends(*given):
    while True:
        pass


def sleeps(*given):
    time.sleep(3600)


def swallows_all(env, q, choose, update, steps):
    while True:
        try:  # noqa: SIM105, as learners write it
            choose(q, env.reset())
        except:  # noqa: E722
            pass


def leaves(*given):
    exit()


def goes_deep(*given):
    return goes_deep(*given)


def of_one_argument(x):
    return x


def looks_past_the_end(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += alpha * (r + gamma * q[s_next + 1].max() - q[s, a])


def fills_with_nan(q, s, a, r, s_next, terminated, alpha, gamma):
    q[:] = math.nan


def of_the_other_sign(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] -= alpha * (r + gamma * q[s_next].max() - q[s, a])


def never_looks_where_it_is(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, r, terminated, _ = env.step(a)
        update(q, s, a, r, s_next, terminated)


def goes_on_for_ever(env, q, choose, update, steps):
    s = env.reset()
    while True:
        a = choose(q, s)
        s_next, r, terminated, _ = env.step(a)
        update(q, s, a, r, s_next, terminated)
        s = s_next


def breaks_the_world(env, q, choose, update, steps):
    s = env.reset()
    env.step(choose(q, s))
    env.env = None
    env.step(choose(q, s))


def stops_after_ten(env, q, choose, update, steps):
    s = env.reset()
    for i in range(steps):
        s = env.step(choose(q, s))[0]
        [0][i // 10]


def always_the_first(p, u):
    return 0


def in_order_of_chance(p, u):
    return int(np.argmax(p))


def no_such_action(p, u):
    return len(p)


def half_an_action(p, u):
    return 0.5


def empties_the_table(q, shape, s, temperature, r_max, gamma, u):
    q[:] = 0
    return int(u * q.shape[1])


def does_not_learn(env, shape, n_actions, r_max, steps, rng, *parameters):
    env.reset()
    for _ in range(steps):
        env.step(int(rng.random() * n_actions))
    return np.zeros((np.prod(shape), n_actions))


def likes_distance(before, after):
    return 100 * after


def shuttles(before, after):
    return 10.0 if after <= 0.05 else 5.0 if before - after > 0.02 else -0.02


FILMS = [
    ("01", "reward", pays_to_stand, "of its 60 steps"),
    ("03", "update", fills_with_nan, "a step, by the right code"),
    ("03", "update", of_the_other_sign, "a step, by the right code"),
    ("03", "learn", never_looks_where_it_is, "a step, by the right code"),
    ("03", "learn", goes_on_for_ever, "Your loop goes on after its 500 steps"),
    ("03", "learn", stops_after_ten, "The film shows its last 11 steps until then."),
    ("04", "draw", always_the_first, "a step, by the right code"),
    ("04", "draw", in_order_of_chance, "a step, by the right code"),
    ("10", "choose", empties_the_table, "a step, by the right code"),
    ("10", "learn", does_not_learn, "a step, by the right code"),
    ("10", "learn_and_evade", does_not_learn, "a step, by the right code"),
    ("13", "arm_reward", likes_distance, "a step, by the right code"),
    ("13", "arm_reward", shuttles, "a step, by the right code"),
    ("16", "follow_reward", pays_to_stand, "a step, by the right code"),
]


@pytest.mark.parametrize("lesson, name, answer, said", FILMS)
def test_a_wrong_answer_is_filmed_beside_the_right_one(lesson, name, answer, said):
    found = tried(lesson, name, answer)
    assert said in found.said
    assert list(found.films) == ["yours", "right"]
    assert 5 <= len(found.films["yours"].frames) <= FILMED


SENTENCES = [
    ("03", "learn", breaks_the_world, "in the line “env.step(choose(q, s))”"),
    ("01", "reward", is_not_a_number, "returns nan, and a reward is one finite number"),
    ("01", "reward", returns_nothing, "returns None"),
    ("01", "reward", never_ends, "takes too long, and was stopped, in the line"),
    ("03", "update", never_ends, "takes too long, and was stopped"),
    ("03", "update", looks_past_the_end, "IndexError"),
    ("03", "update", of_one_argument, "TypeError"),
    ("03", "learn", swallows_all, "takes too long"),
    ("04", "draw", returns_nothing, "The robot cannot go on: there is no action"),
    ("04", "draw", half_an_action, "The robot cannot go on: there is no action"),
    ("04", "draw", no_such_action, "The robot cannot go on: there is no action"),
    ("10", "choose", says_much, "The robot cannot go on: there is no action"),
    ("10", "learn", goes_deep, "RecursionError"),
    ("10", "learn_and_evade", leaves, "SystemExit"),
    ("13", "arm_reward", says_much, "returns much"),
    ("13", "arm_reward", returns_nothing, "returns None"),
    ("16", "follow_reward", is_infinite, "reward is one finite number"),
]


@pytest.mark.parametrize("lesson, name, answer, said", SENTENCES)
def test_where_no_step_can_be_driven_a_sentence_says_why(
    lesson, name, answer, said, capsys
):
    found = tried(lesson, name, answer)
    assert said in found.said and found.said.endswith(NOTHING)
    assert found.films == {}
    assert "much much" not in capsys.readouterr().out


def test_a_function_that_waits_is_stopped(monkeypatch):
    monkeypatch.setattr(by_your_code, "PATIENCE", 0.5)
    exercise = of("04", "draw")
    begin = time.monotonic()
    found = beside(drive_of(exercise), exercise.right, sleeps)
    assert time.monotonic() - begin < 60
    assert "takes too long, and was stopped, in the line “time.sleep(3600)”" in found.said  # fmt: skip


@pytest.mark.parametrize("lesson, name", DRIVEN)
def test_the_right_code_drives_as_itself_and_the_same_luck_gives_the_same_film(
    lesson, name
):
    exercise = of(lesson, name)
    found = beside(drive_of(exercise), exercise.right, exercise.right)
    assert found.said == ALIKE
    yours, right = found.films.values()
    assert len(right.frames) >= 40
    assert are_alike(yours, right)


@pytest.fixture
def in_a_notebook(monkeypatch):
    monkeypatch.setattr(exercises, "is_notebook", lambda: True)
    monkeypatch.delenv("RLROBOT_EDU_PROGRESS", raising=False)


def test_only_a_wrong_answer_has_a_button(in_a_notebook, monkeypatch):
    check = of("04", "draw")
    monkeypatch.setattr(type(check), "keep", None, raising=False)
    assert isinstance(check(always_the_first).below, DriveButton)
    assert check(check.right).below is None, "the course's own"

    def unfinished(p, u): ...

    assert check(unfinished).below is None
    assert check(...).below is None
    assert check(3).below is None
    assert of("04", "softmax")(always_the_first).below is None, "no robot drives by it"


def test_a_right_answer_has_no_button(in_a_notebook, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)

    def draw(p, u):
        return int((np.cumsum(p) <= u).sum())

    verdict = of("04", "draw")(draw)
    assert verdict and verdict.below is None


def test_a_notebook_that_is_run_to_be_saved_has_no_button(monkeypatch):
    monkeypatch.setenv("RLROBOT_EDU_PROGRESS", "0")
    assert _offered(of("04", "draw"), always_the_first) is None


def test_there_is_no_button_without_the_packages_of_a_notebook(
    in_a_notebook, monkeypatch
):
    import sys

    monkeypatch.setitem(sys.modules, "rlrobot_course.drives.button", None)
    verdict = of("04", "draw")(always_the_first)
    assert verdict.below is None and not verdict


def test_pressed_the_button_makes_room_for_the_films(monkeypatch):
    monkeypatch.setattr(by_your_code, "FILMED", 6)  # so that they are soon painted
    sides.by_right.cache_clear()
    exercise = of("04", "draw")
    button = DriveButton(drive_of(exercise), exercise.right, always_the_first)
    assert button.widget.children == (button.button,)
    assert button.button.description == ASKS
    kept = button._repr_mimebundle_()
    (kept, *_) = kept if isinstance(kept, tuple) else (kept,)
    assert kept["text/plain"] == kept["text/html"] == "", "a saved notebook shows it"
    button.button.click()
    sides.by_right.cache_clear()
    text, films = button.widget.children
    assert "By your code the robot earns" in text.value
    assert "<b>yours</b>" in films.value and "<img alt=" in films.value


def test_a_drive_that_fails_itself_says_so_and_shows_no_traceback():
    def fails(function, reel):
        raise SystemExit

    button = DriveButton(fails, always_the_first, always_the_first)
    button.press()
    (text,) = button.widget.children
    assert isinstance(text, ipywidgets.HTML) and FAILS in text.value


def divides(*_):
    return 1 / 0


def holds_on(*_):
    while True:
        try:
            while True:
                pass
        except Exception:
            pass


WRONG = [
    never_ends,
    divides,
    holds_on,
    is_not_a_number,
    returns_nothing,
    says_much,
    is_infinite,
    leaves,
    of_one_argument,
]


@pytest.mark.parametrize("what", WRONG)
@pytest.mark.parametrize("which", [0, 2, 4, 8])
def test_whatever_a_function_does_there_is_a_film_or_a_sentence(which, what, capsys):
    exercise = of(*DRIVEN[which])
    found = beside(drive_of(exercise), exercise.right, what)
    assert found.films or NOTHING in found.said
    assert not capsys.readouterr().out


def test_only_functions_that_drive_a_robot_have_a_drive():
    assert drive_of(of("01", "reward")) and not drive_of(of("01", "bin_of"))


def test_a_notebook_shows_the_card_and_then_the_button(monkeypatch):
    shown = []
    monkeypatch.setattr(
        "IPython.display.display", lambda thing, **_: shown.append(thing)
    )
    verdict = Verdict("wrong", "No.", below="the button")
    verdict._ipython_display_()
    card, button = shown
    assert card == {"text/plain": "✗ No.", "text/html": verdict._repr_html_()}
    assert button == "the button"
    assert verdict == Verdict("wrong", "No."), "what stands below is no part of it"
