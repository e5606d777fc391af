"""Open challenges: a score that anybody can have again, landmarks that repeat, and bad input told in one sentence."""

import itertools
import json
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "studies"))
import challenges as study

from rlrobot_course.authoring.lists import lessons
from rlrobot_course.learner.learners_files import entries
from rlrobot_course.play import challenge as shared
from rlrobot_course.play.challenge import (
    Challenge,
    Score,
    Watched,
    array,
    landmarks,
    number,
    score_of,
)

NOTEBOOKS = lessons(Path(__file__).parents[2])
LESSONS = list(study.ANSWERS)


def best_scores():
    return entries(shared.FILE, score_of)


def toy(**changed) -> Challenge:
    """A challenge whose score is a number from 0 to 10, and one more for each seed."""
    given = {
        "lesson": "15",
        "rules": "Give a number.",
        "unit": "points",
        "read": number(0, 10),
        "seeds": 4,
    }
    return Challenge(
        **(given | {"trial": lambda answer, seed: answer + seed % 10} | changed)
    )


@pytest.fixture
def learner(tmp_path, monkeypatch):
    """The folder of a learner with a notebook."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(shared, "is_notebook", lambda: True)
    return tmp_path


def test_the_table_has_the_landmarks_of_each():
    assert {lesson: list(known) for lesson, known in landmarks().items()} == {
        lesson: list(answers) for lesson, answers in study.ANSWERS.items()
    }


@pytest.mark.parametrize("lesson", LESSONS)
def test_each_landmark_is_clearly_better_than_the_one_before(lesson):
    sign = -1 if study.challenge_of(lesson).least_wins else 1
    known = list(landmarks()[lesson].values())
    assert len(known) > 1
    for worse, better in itertools.pairwise(known):
        assert sign * (better.mean - worse.mean) > worse.half + better.half, (
            "luck could decide"
        )


def test_the_shipped_landmarks_repeat():
    for (_, name, mean, half), shipped in zip(
        study.rows_of("15"), landmarks()["15"].items(), strict=True
    ):
        assert (name, Score(float(mean), float(half))) == shipped


@pytest.mark.long
@pytest.mark.parametrize("lesson", ["04", "11"])
def test_the_shipped_landmarks_of_robots_repeat(lesson):
    name, answer = list(study.ANSWERS[lesson].items())[1]
    score, shipped = study.challenge_of(lesson).score(answer), landmarks()[lesson][name]
    assert score == pytest.approx(shipped, abs=1e-4)


@pytest.mark.long
def test_the_same_answer_has_the_same_score_in_another_process():
    code = "import challenges as s; print(*s.challenge_of('15').score(s.sequential))"
    around = {
        "PYTHONPATH": f"{Path(study.__file__).parent}:{Path(study.__file__).parents[1]}",
        "PYTHONHASHSEED": "7",
    }
    done = subprocess.run(
        [sys.executable, "-c", code],
        env=around,
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.split() == [
        str(x) for x in study.challenge_of("15").score(study.sequential)
    ]


def test_a_score_is_a_mean_with_its_interval_and_the_best_is_kept(learner):
    verdict = toy()(3)
    assert (
        verdict.text == "4.50 ± 2.05 points, over 4 seeds: your best so far."
        and verdict.status == "score"
    )
    assert toy()(1).text.endswith("your best is 4.50 ± 2.05.") and toy()(
        5
    ).text.endswith("your best so far.")
    assert best_scores()["15"].mean == 6.5
    for answer in (5, 2):
        assert toy(lesson="18", least_wins=True)(answer).text.endswith("best so far.")
    assert set(best_scores()) == {"15", "18"} and best_scores()["18"].mean == 3.5
    (learner / "my_challenges.json").write_text('{"15": "x"}', encoding="utf-8")
    assert best_scores() == {}


def test_who_gives_no_answer_is_told_what_counts_and_the_landmarks(learner):
    def unfinished(a, b): ...

    for answer in (..., None, unfinished):
        verdict = toy()(answer)
        assert (
            verdict.status == "waiting"
            and "Give a number." in verdict.text
            and "a guess: 59.00" in verdict.gained
        )
    assert not list(learner.iterdir())


@pytest.mark.parametrize(("read", "answer", "told"), [
    (number(0, 10), 11, "a number from 0 to 10 is expected"), (number(0, 10), "3", "a number from 0 to 10"),
    (number(0, 10), float("nan"), "a number from"), (number(0, 10), [1, 2], "a number from"),
    (array(3, 1, sums_to=1), [0.5, 0.5], "3 probabilities, whose sum is 1, are expected"),
    (array(3, 1, sums_to=1), [0.5, 0.6, -0.1], "3 probabilities"), (array(3, 9), ["a", 1, 2], "could not convert"),
    (array(2, 9), [1, 10], "2 numbers up to 9 are expected"),
])  # fmt: skip
def test_an_answer_that_does_not_fit_is_told_in_a_sentence(read, answer, told):
    verdict = toy(read=read, trial=lambda answer, seed: 0.0)(answer)
    assert (
        verdict.status == "wrong"
        and told in verdict.text
        and verdict.text.startswith("No score: ")
    )


def watched(answer):
    """The verdict on a function that should return a number from 0 to 10."""
    read = number(0, 10)
    return toy(
        read=lambda rule: Watched(rule, "my_rule(x)", read),
        trial=lambda rule, seed: rule(seed),
    )(answer)


def raises(x):
    return 1 / 0


def endless(x):
    while True:
        pass


def by_chance(x):
    return np.random.default_rng(0).random()


@pytest.mark.parametrize(("answer", "told"), [
    (3, "a function is expected, my_rule(x), and this is 3"), (raises, "ZeroDivisionError: division by zero, in the"),
    (lambda x: [x], "my_rule(x) returns [29000]: a number from 0 to 10"), (lambda: 1, "my_rule(x) TypeError"),
    (by_chance, "your function draws random numbers"), (lambda x: exit(), "my_rule(x) SystemExit"),
])  # fmt: skip
def test_what_goes_wrong_in_a_function_is_told_in_a_sentence(answer, told):
    assert told in watched(answer).text


def test_a_function_that_does_not_end_or_takes_long_is_ended(monkeypatch):
    monkeypatch.setattr("rlrobot_grading.answers.limits.SECONDS", 0.2)
    assert "has not ended after" in watched(endless).text
    monkeypatch.setattr(shared, "SECONDS", 0.05)

    def slow(x):
        begun = time.process_time()
        while time.process_time() < begun + 0.04:
            pass
        return 1

    assert "has taken more than" in watched(slow).text


@pytest.mark.parametrize(("lesson", "answer", "told"), [
    ("11", {"laser_front": [0.1, 0.2, 0.3], "laser_left": [1, 2, 3], "laser_right": [1, 2, 3, 4]}, "make 80 states"),
    ("11", {"laser_fornt": [0.2]}, "laser_front"), ("11", 7, "a dict of sensors"),
    ("15", lambda a, b: 1, '"a", "b" or "more" is expected'),
])  # fmt: skip
def test_each_challenge_refuses_what_it_cannot_score(lesson, answer, told):
    verdict = study.challenge_of(lesson)(answer)
    assert verdict.status == "wrong" and told in verdict.text, verdict.text


@pytest.mark.parametrize("lesson", LESSONS)
def test_the_notebook_has_it_once_waiting_and_without_an_answer(lesson):
    path = NOTEBOOKS[lesson]
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    (cell,) = (
        cell for cell in cells if "challenge" in cell["metadata"].get("tags", [])
    )
    assert f"lesson_{lesson}.challenge import challenge" in "".join(
        cell["source"]
    ) and "..." in "".join(cell["source"])
    assert "".join(cell["outputs"][-1]["data"]["text/plain"]) == repr(
        study.challenge_of(lesson)(...)
    )
