"""The scoreboard: a learner's right functions earn what the library's do, and each stair says whose it is."""

import json
import math
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "studies"))
import scoreboard as study

from rlrobot_course.learner.my_functions import take
from rlrobot_course.play import scoreboard as board
from rlrobot_course.play.challenge import Score
from rlrobot_course.play.scoreboard import earned, library_stairs, scoreboard


def at_random(world, steps):
    """Lesson 03: Q-learning, which learns and does not use it."""
    update, learn = take("03", "update", "learn")

    def choose(q, s):
        return int(world.u * world.n_actions)

    learn(
        world,
        world.table(),
        choose,
        lambda q, *step: update(q, *step, alpha=0.1, gamma=0.9),
        steps,
    )


def q_learning(world, steps, preferences):
    update, learn = take("03", "update", "learn")
    learn(
        world,
        world.table(),
        by(world, preferences),
        lambda q, *step: update(q, *step, 0.1, 0.9),
        steps,
    )


def by(world, preferences, temperature=lambda: 1.0):
    """choose(q, s) by the learner's softmax."""
    draw, softmax, normalise = take("04", "draw", "softmax", "normalise")

    def choose(q, s):
        return draw(
            softmax(
                normalise(preferences(world, q, s), world.r_max, 0.9), temperature()
            ),
            world.u,
        )

    return choose


def plain(world, q, s):
    return q[s]


def biased_q_learning(world, steps):
    bias = take("05", "bias")
    q_learning(world, steps, lambda world, q, s: q[s] + bias(q, world.size.shape, s))


def sarsa(world, steps):
    update, learn = take("06", "sarsa_update", "sarsa_learn")
    learn(
        world,
        world.table(),
        by(world, plain),
        lambda q, *step: update(q, *step, 0.1, 0.9),
        steps,
    )


def sarsa_lambda(world, steps):
    update, learn, e = (
        take("07", "sarsa_lambda_update"),
        take("06", "sarsa_learn"),
        world.table(),
    )
    learn(
        world,
        world.table(),
        by(world, plain),
        lambda q, *step: update(q, e, *step, 0.1, 0.9, 0.9),
        steps,
    )


def true_online(world, steps, temperature=lambda: 1.0):
    update, learn = take("08", "true_online_update"), take("06", "sarsa_learn")
    e, q_old = world.table(), 0.0

    def learn_from(q, *step):
        nonlocal q_old
        q_old = update(q, e, q_old, *step, 0.1, 0.9, 0.9)

    learn(world, world.table(), by(world, plain, temperature), learn_from, steps)


def evading(world, steps):
    """Lesson 09: loop evasion stands between the world and the loop."""
    new_temperature, step, states, rewards, T = (
        take("09", "new_temperature"),
        world.step,
        [],
        [],
        1.0,
    )

    def step_and_watch(a):
        nonlocal T
        s, r, *ends = step(a)
        states[:], rewards[:] = [*states, s][-21:], [*rewards, r][-21:]
        if len(states) == 21:
            T = new_temperature(T, states, rewards, s, 1.0)
        return s, r, *ends

    world.step = step_and_watch
    true_online(world, steps, lambda: T)


def all_of_it(world, steps):
    learn = take("10", "learn_and_evade")
    learn(
        world,
        world.size.shape,
        world.n_actions,
        world.r_max,
        steps,
        world,
        0.1,
        0.9,
        0.9,
        1.0,
    )


LEARNERS = {
    "03": at_random,
    "04": lambda world, steps: q_learning(world, steps, plain),
    "05": biased_q_learning,
    "06": sarsa,
    "07": sarsa_lambda,
    "08": true_online,
    "09": evading,
    "10": all_of_it,
}


def kept(folder):
    return json.loads((folder / "my_scores.json").read_text())


@pytest.fixture
def learner(tmp_path, monkeypatch):
    """The folder of a learner with a notebook, in whose world an hour has four steps and two robots."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(board, "is_notebook", lambda: True)
    monkeypatch.setattr(board, "HOUR", 4)
    return tmp_path


def forward(world, steps):
    world.reset()
    for _ in range(steps):
        world.step(8)


@pytest.mark.parametrize("lesson", study.LESSONS)
def test_a_learners_functions_earn_number_for_number_what_the_library_earns(
    lesson, monkeypatch
):
    monkeypatch.setattr(board, "HOUR", 200)
    monkeypatch.setattr(study, "HOUR", 200)
    _, *agent = study.LESSONS[lesson]
    assert list(earned(LEARNERS[lesson], 2)) == [
        study.earned(*agent, "held", board.FIRST_SEED + i) for i in range(2)
    ]


@pytest.mark.long
def test_an_hour_of_a_learners_robots_is_the_given_stair():
    each = earned(LEARNERS["04"])
    mean, half = board.mean_and_half(each)
    given = library_stairs()["04"]
    assert Score(round(mean, 4), round(half, 4)) == given.score
    assert each == pytest.approx(given.each, abs=6e-5)  # the table has four digits


@pytest.mark.parametrize("robot", study.WORLDS)
def test_the_table_has_all_lessons(robot):
    named = {lesson: label for lesson, (label, *_) in study.LESSONS.items()}
    further = {
        lesson: label
        for lesson, (label, *_) in study.FURTHER.items()
        if robot == "held"
    }
    assert {
        lesson: stair.label for lesson, stair in library_stairs(robot).items()
    } == named
    assert {
        lesson: stair.label
        for lesson, stair in library_stairs(robot, study.ALL).items()
    } == named | further


def test_the_mean_of_a_stair_is_that_of_its_robots():
    for stair in library_stairs().values():
        assert len(stair.each) == board.ROBOTS
        assert stair.score == pytest.approx(board.mean_and_half(stair.each), abs=2e-4)


def test_own_scores_are_kept_and_shown_as_ones_own_in_later_lessons(learner):
    first = scoreboard("03", forward, "your")
    mean, half, each = kept(learner)["03"].values()
    assert (mean, half) == board.mean_and_half(each) and len(each) == board.ROBOTS
    assert f"lesson 03, at random: {Score(mean, half)} (your functions)" in first.alt
    later = scoreboard("05", forward, "the given")
    assert f"lesson 03, at random: {Score(mean, half)} (your functions)" in later.alt
    assert (
        f"lesson 04, softmax: {library_stairs()['04'].score} (the given functions)"
        in later.alt
    )
    assert "lesson 06" not in later.alt
    assert "Still to come: 06 SARSA, 07 traces" in later.alt


@pytest.mark.parametrize("owner", ["the given", "partly your"])
def test_what_is_not_all_ones_own_is_not_kept(learner, owner):
    assert f"({owner} functions)" in scoreboard("04", forward, owner).alt
    assert not (learner / "my_scores.json").exists()


def test_nothing_is_kept_or_read_where_there_is_no_notebook(learner, monkeypatch):
    (learner / "my_scores.json").write_text('{"03": [9.0, 0.1]}')
    monkeypatch.setattr(board, "is_notebook", lambda: False)
    assert "9.00" not in scoreboard("04", forward, "your").alt
    assert kept(learner) == {"03": [9.0, 0.1]}


def test_a_file_of_means_alone_is_read_and_keeps_them(learner):
    (learner / "my_scores.json").write_text('{"03": [9.0, 0.1]}')
    assert "9.00 ± 0.10 (your functions)" in scoreboard("04", forward, "your").alt
    assert kept(learner)["03"] == [9.0, 0.1] and len(kept(learner)["04"]["each"]) == 16


@pytest.mark.parametrize(
    "text",
    [
        '{"03": [9.0, 0.1], "04": "?"}',
        '{"04": [NaN, 1]}',
        '{"04": {"mean": 1, "half": 1}}',
        '{"04": {"mean": 1, "half": 1, "each": [1, 2]}}',
        json.dumps({"04": {"mean": 1, "half": 1, "each": [math.nan] * 16}}),
        "[]",
        "{",
        "\0",
    ],
)
def test_a_damaged_file_is_put_aside_and_the_learner_is_told(learner, text, capsys):
    (learner / "my_scores.json").write_text(text)
    alt = scoreboard("04", forward, "your").alt
    assert (learner / "my_scores.old.json").read_text() == text
    assert "my_scores.old.json" in capsys.readouterr().out
    assert ("9.00 ± 0.10 (your functions)" in alt) == text.startswith('{"03": [9.0')


def test_nothing_is_printed_where_all_is_well(learner, capsys):
    scoreboard("04", forward, "your")
    assert capsys.readouterr().out == ""


def test_robots_that_learn_for_less_than_an_hour_have_no_stair(learner):
    with pytest.raises(ValueError, match="should take 4 steps, and took 3"):
        scoreboard("04", lambda world, steps: forward(world, steps - 1), "your")


def test_a_lesson_without_a_stair_is_refused(learner):
    with pytest.raises(ValueError, match="no lesson '02', only 03, 04"):
        scoreboard("02", forward, "your")


def test_all_lessons_have_the_same_robots(learner):
    seen = []
    for _ in range(2):
        earned(lambda world, steps: (forward(world, steps), seen.append(world.u)), 2)
    assert seen[:2] == seen[2:] and seen[0] != seen[1]
