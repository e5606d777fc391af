"""Old questions: asked again at growing distances, kept, and no answer is given away by its length or its place."""

import json
import re
from collections import Counter
from pathlib import Path

import pytest

from rlrobot_course.authoring.lists import lessons
from rlrobot_course.questions.old_questions import (
    QUESTIONS,
    OldQuestions,
    due,
    latest_answers,
)

NOTEBOOKS = lessons(Path(__file__).parents[2])
LESSONS = [f"{number:02}" for number in range(2, 19)]
ALL = [question for questions in QUESTIONS.values() for question in questions]


def test_each_main_lesson_but_the_last_has_three_questions():
    expected = {f"{n:02}": 3 for n in range(1, 18)} | {
        "01": 4
    }  # which lesson 02 asks about three times, and 03 once
    assert {
        lesson: len(questions) for lesson, questions in QUESTIONS.items()
    } == expected
    assert len({question.ask for question in ALL}) == len(ALL)


def test_lessons_are_asked_about_after_one_three_and_six_lessons_each_time_by_another_question():
    for number in range(7, 19):
        assert [question.lesson for question in due(f"{number:02}")] == [
            f"{number - n:02}" for n in (1, 3, 6)
        ]
    for number in range(2, 7):
        asked = due(f"{number:02}")
        assert len(set(asked)) == 3 and all(
            question.lesson < f"{number:02}" for question in asked
        )
    times = Counter(question for lesson in LESSONS for question in due(lesson))
    assert (
        max(times.values()) == 2
    )  # at the beginning there are few lessons to ask about
    for lesson in ("03", "06", "09"):
        assert times.keys() >= set(QUESTIONS[lesson])


def test_a_question_that_was_answered_wrong_comes_again_in_the_place_of_the_next_one():
    later = due("06")[1]
    assert later == QUESTIONS["03"][2]
    first = QUESTIONS["03"][0]
    assert due("06", {first.name: first.wrong[0]})[1] == first
    assert due("06", {first.name: first.right})[1] == later
    again = due(
        "03", {question.name: question.wrong[0] for question in QUESTIONS["01"]}
    )
    assert len(set(again)) == 3


def test_the_right_answer_is_known_by_neither_its_length_nor_its_place():
    places = Counter(question.answers.index(question.right) for question in ALL)
    lengths = Counter(
        sorted(map(len, question.answers)).index(len(question.right))
        for question in ALL
    )
    for counted in (places, lengths):
        assert set(counted) == {0, 1, 2} and max(counted.values()) < len(ALL) / 2, (
            counted
        )


def test_the_wrong_answers_do_not_begin_alike_where_the_right_one_does_not():
    for question in ALL:
        first, *others = (
            answer.split()[0].strip(",:")
            for answer in (question.right, *question.wrong)
        )
        assert first in others or len(set(others)) > 1, question


@pytest.mark.parametrize("question", ALL, ids=lambda question: question.name)
def test_a_question_is_short_and_has_one_right_answer_and_a_reason(question):
    assert question.ask.endswith("?") and len(question.ask.split()) <= 30
    assert question.why.endswith(".") and len(question.why.split()) <= 25
    assert len(set(question.answers)) == 3 and all(
        len(answer) <= 60 for answer in question.answers
    )
    assert question.answers == question._replace(lesson="99").answers


@pytest.mark.parametrize("lesson", LESSONS)
def test_each_lesson_has_its_three_before_its_summary_and_its_saved_page_shows_them_in_plain_text(
    lesson,
):
    path = NOTEBOOKS[lesson]
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    at = [
        i
        for i, cell in enumerate(cells)
        if f'OldQuestions("{lesson}")' in "".join(cell["source"])
    ]
    assert len(at) == 1 and len(cells) - at[0] <= 6, "once, before the summary"
    saved = cells[at[0]]["outputs"][0]["data"]
    assert "".join(saved["text/plain"]) == repr(OldQuestions(lesson))
    page = "".join(saved["text/html"])
    assert len(re.findall("<li>", page)) == 9 and "✓" not in page
    assert not any(question.why in page for question in due(lesson))


def test_an_answer_is_told_at_once_and_kept(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("rlrobot_course.questions.prediction.is_notebook", lambda: True)
    first, second, _ = OldQuestions("03").asked
    assert first._told.value == ""
    first.choose(first.about.right)
    second.choose(second.about.wrong[0])
    assert first._told.value.startswith("✓") and second._told.value.startswith("✗")
    first.choose(first.about.wrong[0])  # too late: the right answer is told
    assert OldQuestions("03").asked[0].chosen == first.about.right
    again = OldQuestions("04").asked[1]
    assert again.about == second.about and again.chosen == "", (
        "answered wrong, so it comes again, and asks anew"
    )
    again.choose(again.about.right)
    assert OldQuestions("03").asked[1].chosen == second.about.wrong[0]
    assert [one.about.name for one in OldQuestions("06").asked] == [
        question.name for question in due("06")
    ]
    assert latest_answers(tmp_path / "nobody") == {}


def test_a_file_that_is_spoilt_is_as_none(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("rlrobot_course.questions.prediction.is_notebook", lambda: True)
    Path("my_old_questions.json").write_text("[1, 2", encoding="utf-8")
    assert len(OldQuestions("07").asked) == 3 and latest_answers() == {}
    Path("my_old_questions.json").write_text(
        '{"02: 01 1": 7, "77 9": "x"}', encoding="utf-8"
    )
    assert len(OldQuestions("04").asked) == 3
