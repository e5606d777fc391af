"""The checks of the exercises: right answers pass, typical wrong ones get the hint that was made for them."""

from __future__ import annotations

import doctest
import functools
import importlib
import linecache
import sys
import traceback
from pathlib import Path

import numpy as np
import pytest
from right_answers import RIGHT

import rlrobot_course
import rlrobot_grading
from rlrobot_course.lesson_03.exercises import target, update
from rlrobot_edu.show import palette
from rlrobot_grading.answers.source import edited
from rlrobot_grading.exercises import verdict as verdicts
from rlrobot_grading.exercises.exercise import Exercise
from rlrobot_grading.exercises.mistake import Mistake
from rlrobot_grading.exercises.page import read_page, with_pages
from rlrobot_grading.exercises.question import Question
from rlrobot_grading.hints.detectors import DETECTORS
from rlrobot_grading.hints.evidence import Hint

LESSONS = sorted(
    path.parent.name
    for path in Path(rlrobot_course.__file__).parent.glob("*/exercises.py")
)


def exercises(lesson: str) -> dict:
    """The exercises of a lesson by name."""
    return vars(importlib.import_module(f"rlrobot_course.{lesson}.exercises").check)


def wrong_answers(lesson: str) -> dict:
    """By the names of its exercises: wrong answers, each with the id that its verdict must have."""
    wrong = {}
    for name, exercise in exercises(lesson).items():
        wrong[name] = [
            (answer, known)
            for known, answers in exercise.witnesses.items()
            for answer in answers
        ]
        if isinstance(exercise, Question):
            wrong[name] += [
                (mistake.wrong, mistake.id) for mistake in exercise.mistakes
            ]
    return wrong


SLOW = ("lesson_10", "assignment_4")  # a right answer takes a second
EVERY = [(lesson, name) for lesson in LESSONS for name in exercises(lesson)]
WRONG = [
    (lesson, name, i)
    for lesson in LESSONS
    for name, answers in wrong_answers(lesson).items()
    for i in range(len(answers))
]


def some_long(rows: list[tuple]) -> list:
    """The rows as parameters of a test that judges answers: with those of lesson 10, which learn, it takes seconds."""
    return [
        pytest.param(*row, marks=[pytest.mark.long] * (row[0] == "lesson_10"))
        for row in rows
    ]


def some_nightly(rows: list[tuple]) -> list:
    """The rows as parameters of what is tried on all exercises; those that learn in every case wait for the night."""
    return [
        pytest.param(*row, marks=[pytest.mark.nightly] * (row[0] in SLOW))
        for row in rows
    ]


@pytest.fixture(autouse=True)
def search_that_takes_its_time(monkeypatch):
    """Which hint is found must not depend on how busy the computer is."""
    for search in ("as_if", "detectors"):
        monkeypatch.setattr(f"rlrobot_grading.hints.{search}.SECONDS", 60.0)


@functools.cache
def verdict_on_wrong(lesson: str, name: str, i: int):
    """What the check says of a wrong answer."""
    return exercises(lesson)[name](wrong_answers(lesson)[name][i][0])


def waiting_answer(*_):
    """An exercise as the learner finds it."""
    ...


def half_done_answer(*_):
    return 1 + ...


def test_an_exercise_has_a_name_of_its_own():
    names = [name for _, name in EVERY]
    assert {name for name in names if names.count(name) > 1} <= {"learn"}, (
        "the whole learner, of lessons 03 and 10"
    )


@pytest.mark.parametrize(("lesson", "name"), EVERY)
def test_the_solution_is_right(lesson, name):
    exercise = exercises(lesson)[name]
    verdict = exercise(exercise.right)
    assert verdict, verdict
    assert repr(verdict).startswith("✓ ")


@pytest.mark.parametrize(
    ("lesson", "name"), [(lesson, name) for lesson in RIGHT for name in RIGHT[lesson]]
)
def test_another_right_answer_is_right_too(lesson, name):
    verdict = exercises(lesson)[name](RIGHT[lesson][name])
    assert verdict, verdict


@pytest.mark.parametrize(("lesson", "name"), EVERY)
def test_an_unsolved_exercise_waits(lesson, name):
    exercise = exercises(lesson)[name]
    answers = [..., None] + (
        [waiting_answer, half_done_answer] if isinstance(exercise, Exercise) else []
    )
    for answer in answers:
        assert exercise(answer).status == "waiting"
        assert "waits for your answer" in repr(exercise(answer))


@pytest.mark.parametrize(("lesson", "name"), some_long(EVERY))
def test_every_check_is_tried_on_four_wrong_answers(lesson, name):
    wrong = wrong_answers(lesson)[name]
    assert len(wrong) >= 4
    hints = [verdict_on_wrong(lesson, name, i).hint for i in range(len(wrong))]
    assert len(set(hints)) >= 4, "four different mistakes, four different hints"


@pytest.mark.parametrize(("lesson", "name", "i"), some_long(WRONG))
def test_a_typical_mistake_gets_its_hint(lesson, name, i):
    verdict, known = (
        verdict_on_wrong(lesson, name, i),
        wrong_answers(lesson)[name][i][1],
    )
    assert verdict.status == "wrong" and verdict.id == known and verdict.hint, verdict


@pytest.mark.parametrize(("lesson", "name"), some_long(EVERY))
def test_the_known_mistakes_are_mistakes_and_differ(lesson, name):
    exercise = exercises(lesson)[name]
    values = [mistake.wrong for mistake in exercise.mistakes]
    answers = exercise.wrong_functions if isinstance(exercise, Exercise) else values
    for mistake, answer in zip(exercise.mistakes, answers, strict=True):
        with np.errstate(all="ignore"):  # some overflow
            verdict = exercise(answer)
        assert verdict.status == "wrong"
        assert (verdict.id, verdict.hint) == (mistake.id, mistake.hint)


@pytest.mark.parametrize("lesson", LESSONS)
def test_an_id_is_that_of_a_mistake_or_of_whatever_else_finds_a_hint(lesson):
    others = set(DETECTORS) | {
        "exception",
        "spoilt",
        "form",
        "formula",
        "first_step",
        "no_number",
        "remembers",
        "rule",
        "as_given",
    }
    for name, exercise in exercises(lesson).items():
        ids = [mistake.id for mistake in exercise.mistakes]
        assert all(ids) and len(set(ids)) == len(ids)
        unknown = exercise.witnesses.keys() - ids - others
        assert not {
            known for known in unknown if not set(known.split("+")) <= set(ids)
        }, name


PAGE = """# twice

return twice the number

## Hints

1. It is a sum.
2. Of x and x.

## Result

You can count.

## Names

- `y` there is none

## Mistakes

- **half** one x is missing.
  `2 * ` → nothing
  ```python
  n = 3

  def g(x):
      return x
  ```
  ```python
  def f(x):
      return 1 / 0
  ```
- **other** this is another function.
  ```python
  def twice(x):
      return given
  ```
- **exception**
  ```python
  def twice(x):
      return y
  ```
"""


def twice(x):
    return 2 * x


def test_a_page_has_all_that_is_text_in_an_exercise(tmp_path):
    (tmp_path / "twice.md").write_text(PAGE)
    exercise = Exercise(twice, [{"x": 1}, {"x": 3}], returns="twice")
    check = with_pages(
        {"__file__": str(tmp_path / "exercises.py"), "given": 4}, twice=exercise
    ).twice
    assert (check.task, check.gained) == ("return twice the number", "You can count.")
    assert check.hints == ["It is a sum.", "Of x and x."] and check.lenders == {
        "y": "there is none"
    }
    assert [mistake.id for mistake in check.mistakes] == ["half", "other"]
    assert [wrong(5) for wrong in check.wrong_functions] == [5, 4]
    assert [*check.witnesses] == ["half", "exception"]
    assert check.witnesses["half"][0](7) == 7, (
        "of several definitions the last is the answer"
    )
    with pytest.raises(ZeroDivisionError) as error:
        check.witnesses["half"][1](7)
    assert traceback.extract_tb(error.value.__traceback__)[-1].line == "return 1 / 0"
    assert check(twice) and check(lambda x: x).id == "half"


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        (
            "- **other** ",
            "* other: ",
            r"twice\.md, line 32: a mistake .* not by '\* other: this",
        ),
        (
            "# twice\n",
            "# once\n",
            "must begin with the line '# twice' and, below it, the task",
        ),
        (
            "      return y\n  ```\n",
            "      return y\n",
            "line 38: this block of Python has no end",
        ),
        (
            "  ```python\n  def twice(x):\n      return given\n  ```\n",
            "",
            "below other there must be an edit",
        ),
    ],
)
def test_what_is_wrong_with_a_page_is_told(old, new, told, tmp_path):
    page = tmp_path / "twice.md"
    page.write_text(PAGE.replace(old, new))
    with pytest.raises(ValueError, match=told):
        read_page(page, {})


def target_for_edits(q, r, s_next, terminated, gamma):
    """Not a place for an edit: terminated."""
    return r + gamma * (0 if terminated else target_for_edits.best(q[s_next]))


target_for_edits.best = max


def test_an_edit_changes_the_body_wherever_the_text_occurs_and_all_at_once():
    assert edited(update, {"gamma": "1", "alpha": "2"}).__code__.co_varnames[6:8] == (
        "alpha",
        "gamma",
    )
    assert (
        edited(target_for_edits, {"r +": "gamma +", "gamma *": "r *"})(
            [[5.0]], 10.0, 0, False, 0.5
        )
        == 50.5
    )
    assert (
        edited(target_for_edits, {"(0 if": "(1 if"})([[5.0]], 10.0, 0, False, 0.5)
        == 12.5
    ), "it calls the right one"


def test_an_edit_that_fits_no_longer_is_told_when_the_lesson_is_loaded():
    with pytest.raises(
        ValueError, match=r"'np\.max\(' does not occur in the body of target"
    ):
        Exercise(
            target,
            [],
            mistakes={"none": Mistake("no such text", {"np.max(": "np.argmax("})},
        )


def test_a_verdict_names_the_first_wrong_step_with_both_values():
    check = exercises("lesson_03")["update"]
    text = repr(check(check.witnesses["past_the_end"][0]))
    assert f"Step 5 of {len(check.tape)}" in text
    assert "s = 0, a = 1, r = 10, s_next = 3, terminated = True" in " ".join(
        text.split()
    )
    row = next(line for line in text.splitlines() if "q[0, 1]" in line)
    before = 2.0 + 0.1 * (10 + 0.9 * 5.5 - 2.0)  # step 1
    assert float(row.split()[-2]) == pytest.approx(
        before + 0.1 * (10 - before), abs=1e-3
    )
    assert float(row.split()[-1]) > float(row.split()[-2])


def test_the_answer_may_rename_its_parameters():
    def answer(table, reward, after, done, discount):
        return reward if done else reward + discount * table[after].max()

    assert exercises("lesson_03")["target"](answer)


def test_what_should_only_be_read_may_not_be_changed_even_where_the_result_is_right():
    check = exercises("lesson_03")["target"]

    def spoils(q, r, s_next, terminated, gamma):
        q[s_next] *= gamma
        return r if terminated else r + q[s_next].max()

    verdict = check(spoils)
    assert (
        verdict.status == "wrong"
        and "changes q, which it should only read" in verdict.text
    )
    assert "q.copy()" in verdict.hint
    assert check(target), "the next answer gets inputs of its own"


def learner(source):
    """The function `answer` of a learner's cell, whose names are its own."""
    cell, file = {"np": np}, f"<cell {len(linecache.cache)}>"
    linecache.cache[file] = len(source), None, source.splitlines(keepends=True), file
    exec(compile(source, file, "exec"), cell)
    return cell["answer"]


STUBBORN = """
def answer(q, *_):
    while True:
        try: q.max()
        except: pass
"""
WITHOUT_CALLS = """
def answer(*_):
    while True:
        try: pass
        except BaseException: pass
"""
LOOP_IN_A_TRY = """
def answer(*_):
    while True:
        try:
            while True: x = 1
        except BaseException:
            continue
"""


@pytest.mark.parametrize(
    "source",
    [
        "def answer(*_):\n    while True: pass",
        "def answer(*_):\n    while True:\n        pass",
        STUBBORN,
        WITHOUT_CALLS,
        LOOP_IN_A_TRY,
    ],
)
def test_an_endless_loop_is_ended_and_told_with_its_line(source, monkeypatch):
    monkeypatch.setattr("rlrobot_grading.answers.limits.SECONDS", 0.3)
    traced = sys.gettrace()
    verdict = exercises("lesson_03")["target"](learner(source))
    assert verdict.status == "wrong" and "has not ended" in verdict.text
    assert "never ends" in verdict.hint
    assert sys.gettrace() is traced, "whoever looked before looks on"


CALLS = """
def answer(env, q, choose, update, steps):
    s = env.reset()
    while True:
        a = choose(q, s)
        s, r, terminated, truncated = env.step(a)
"""


def test_a_loop_that_ends_in_a_call_of_something_else_is_told_with_the_learners_line(
    monkeypatch,
):
    monkeypatch.setattr("rlrobot_grading.answers.limits.SECONDS", 0.3)
    text = exercises("lesson_03")["learn"](learner(CALLS)).text
    assert "has not ended" in text and "in the line “" in text


def test_chance_in_an_answer_is_told():
    dice = learner(
        "def answer(p, u):\n    return np.random.choice(len(p), p=p) * (u < 2)"
    )
    assert exercises("lesson_04")["draw"](dice).hint.endswith("Is there chance in it?")
    draws = learner(
        "def answer(q_s, epsilon):\n    return np.random.randint(len(q_s)) + (epsilon > 2)"
    )
    assert (
        "asked is an array of 5" in exercises("lesson_04")["epsilon_greedy"](draws).hint
    )


def test_probabilities_that_do_not_sum_to_1_are_told_with_the_sum_that_is_shown():
    halves = learner(
        "def answer(q_s, epsilon):\n    return np.where(q_s == q_s.max(), 0.8, 0)"
    )
    verdict = exercises("lesson_04")["epsilon_greedy"](halves)
    assert (
        "p[1]",
        "0.44",
        "0.8",
    ) in verdict.rows and "yours sum to 1.6 here" in verdict.hint


def test_one_case_alone_that_is_right_is_called_a_coincidence():
    wrong = learner(
        SIGNATURE + "return r if terminated and r > 5 else r + 7 * gamma + s_next"
    )
    assert "in which" not in exercises("lesson_03")["target"](wrong).hint


SIGNATURE = "def answer(q, r, s_next, terminated, gamma):\n    "
HINTS = {  # body of an answer to lesson 03's target: a part of the hint
    "return r + gama * 0": "Do you mean gamma?",
    "return maths.inf": "is not known",
    "return math.inf": "import math",
    "return r + gamma * q[s_next, 7]": "has 3 columns, numbered from 0, and number 7",
    "return r + gamma * q[s_next, 0, 0]": "more numbers in the square brackets",
    "return r + gamma * q(s_next)": "square brackets",
    "best = max(q[s_next]) if terminated is None else best": "before it has a value",
    "return q.index(r)": "nothing called index",
    "return r / 0": "divided by 0",
    "print(r if terminated else r + gamma * max(q[s_next]))": "print shows a value",
    "yield r": "yield",
    "return str(r)": "is text",
    "return q[s_next].max": "brackets that call it are missing",
    "return [r if terminated else r + gamma * max(q[s_next])]": "brackets too many",
    "return -(r if terminated else r + gamma * max(q[s_next]))": "the sign",
    "return 3 + (r if terminated else r + gamma * max(q[s_next]))": "too large by 3, always",
    "return 2 * (r if terminated else r + gamma * max(q[s_next]))": "2 times the right ones",
    "return round(r if terminated else r + gamma * max(q[s_next]), 1)": "rounded to 1 digit",
    "return r + max(q[s_next])": "two things at once",
    "return 7.5": "always returns 7.5",
    "return r**3 + 1 if terminated else r + gamma * max(q[s_next])": "in which terminated is True",
    "return answer(q, r, s_next, terminated, gamma)": "calls itself",
    "row = [0]\n    return row[len(row)]": "row has one entry, number 0, and len(row) is 1",
    "row = []\n    return row[0]": "row is empty here",
    "row = list(q[s_next])\n    return [row[x] for x in row]": "and an index is a whole number. for x in row runs over",
    "return q[max]": "max is a function, and an index is a number",
    "return r + gamma * q[s_next] @ gamma": "@ multiplies matrices",
    "return np.zeros(3, 4)": "in brackets of their own",
    "return (r > 0) & gamma": "conditions are joined with and",
    "return gamma * (r if terminated else r + gamma * max(q[s_next]))": "times gamma, in every",
    "return r_next + 1": "is not known",
    "numbers = []\n    numbers = numbers.append(r)\n    numbers.append(r)": "without numbers = ",
    "return r if q[s_next] == max(q[s_next]) else gamma": "comparing an array gives one for each entry",
    "return r > max": "without the round brackets",
    "return answer(q, r)": "answer takes (q, r, s_next, terminated, gamma)",
}


@pytest.mark.parametrize("body", HINTS)
def test_what_a_wrong_answer_shows_in_every_case_is_told(body):
    verdict = exercises("lesson_03")["target"](learner(SIGNATURE + body))
    assert verdict.status == "wrong" and HINTS[body] in verdict.hint, verdict


FOUND_BY = {  # detector that finds the hint: body of an answer to lesson 03's target
    "chance": "return r + np.random.rand()",
    "known_mistake": "return r + gamma * max(q[s_next])",
    "values": "return 3 + (r if terminated else r + gamma * max(q[s_next]))",
    "two_mistakes": "return r + max(q[s_next])",
    "one_change": "return r if terminated else r + gamma * max(q[s_next]) / 2",
    "code": "return r ** 2 + 0.3 * q[s_next, 0] * terminated",
    "cases": "return r**3 + 1 if terminated else r + gamma * max(q[s_next])",
    "": "return r ** 2 + gamma * q[s_next, 0] * terminated",
}


def test_the_first_detector_that_has_a_hint_decides():
    """Of each kind an answer; those before it in the list find nothing in it, and its verdict tells what they said."""
    assert [
        name
        for name in DETECTORS
        if name not in ("in_place", "notebook", "events", "memory", "left")
    ] == list(FOUND_BY)[:-1]
    check = exercises("lesson_03")["target"]
    for name, body in FOUND_BY.items():
        answer = learner(SIGNATURE + body)
        seen = check.evidence(answer, check.outcomes(answer))
        found = [
            (detector, hint)
            for detector, find in DETECTORS.items()
            if (hint := find(seen))
        ]
        assert (found[0][0] if found else "") == name, body
        verdict, told = check.judge(answer), found[0][1] if found else ""
        assert (verdict.id, verdict.hint) == (
            told if isinstance(told, Hint) else (name, told)
        ), body


def test_one_change_is_told_in_the_names_of_the_answer():
    check = exercises("lesson_03")["target"]
    said = check(
        learner(
            "def answer(q, r, s2, done, g):\n    return r if done else r + g * max(q[s2]) / 2"
        )
    ).hint
    assert said == "it answers as if “g * max(q[s2])” were halved."


LINES = {  # by exercise, a wrong answer, and what is told of it
    ("lesson_02", "discounted_return"):
        ("answer(rewards, gamma):\n result = 0\n for i, x in enumerate(rewards): result += gamma ** i * x * gamma\n"
         " return result", "“gamma ** i * x” were multiplied by “gamma”, too"),
    ("lesson_03", "target"):
        ("answer(q, r, s_next, terminated, gamma): return r if terminated else gamma * max(q[s_next])",
         "“r” were left out."),
    ("lesson_04", "epsilon_greedy"):
        ("answer(q_s, epsilon): return epsilon / len(q_s) + (1 - epsilon) * (q_s == min(q_s)) / sum(q_s == min(q_s))",
         "“min” stood in place of “max”"),
    ("lesson_06", "sarsa_update"):
        ("answer(q, s, a, r, s_next, a_next, terminated, alpha, gamma):\n"
         " target = r if terminated else r + gamma * q[s_next, a_next]\n q[s, a] -= alpha * (target - q[s, a])",
         "“alpha * (target - q[s, a])” were taken off “q[s, a]”, not added"),
    ("lesson_08", "dutch"): ("answer(e, alpha): return -alpha * e + 1", "0 stood in place of 1 in “1 - alpha”."),
    ("assignment_3", "trace_after"):
        ("answer(path, n, decay, kind):\n e = np.zeros(n)\n for s in path:\n  e *= decay\n  e[s] = 1\n return e",
         "“kind == 'accumulating'” never held"),
}  # fmt: skip


@pytest.mark.parametrize(("lesson", "name"), LINES)
def test_one_change_is_told_in_the_variables_of_the_answer_with_all_brackets(
    lesson, name
):
    check, (source, said) = exercises(lesson)[name], LINES[lesson, name]
    answer = learner(f"def {source}")
    told = DETECTORS["one_change"](check.evidence(answer, check.outcomes(answer)))
    assert said in told, told


LOOP = """
def answer(env, q, pick, learn, steps):
    state = env.reset()
    for _ in range(steps):
        action = pick(q, state)
        after, reward, done, cut = env.step(action)
        {}
"""
EVENTS = {
    "state = env.reset() if done or cut else after": "yours never calls update",
    "learn(q, state, action, reward, after, done); state = env.reset() if done or cut else state":
        "in call 3 of choose, s is 0 and should be 1",
    "learn(q, state, action, reward, after, done or cut); state = env.reset() if done or cut else after":
        "in call 2 of update, terminated is True and should be False",
}  # fmt: skip


@pytest.mark.parametrize("line", EVENTS)
def test_the_first_call_of_a_loop_that_differs_is_told(line):
    check = exercises("lesson_03")["learn"]
    answer = learner(LOOP.format(line))
    told = DETECTORS["events"](check.evidence(answer, check.outcomes(answer)))
    assert EVENTS[line] in told


def test_a_table_that_does_not_change_is_told_so():
    check = exercises("lesson_08")["true_online_update"]
    answer = learner(
        "def answer(q, e, q_old, s, a, r, s_next, a_next, end, alpha, gamma, lam):\n"
        " after = 0 if end else q[s_next, a_next]\n d, old, e = r + gamma * after - q[s, a], q[s, a], e.copy()\n"
        " e[s, a] = (1 - alpha) * e[s, a] + 1\n q += alpha * (d + old - q_old) * e\n q[s, a] -= alpha * (old - q_old)\n"
        " return after"
    )
    told = DETECTORS["memory"](check.evidence(answer, check.outcomes(answer)))
    assert told == "e does not change."


def test_arguments_that_are_not_looked_at_are_told():
    taken = learner(
        "gamma = 0.3\ndef answer(q, r, s_next, done, discount):\n    return r ** 2 + gamma * q[s_next, 0] * done"
    )
    assert (
        "takes gamma from the notebook" in exercises("lesson_03")["target"](taken).hint
    )
    unread = learner(
        "def answer(q, r, after, done, discount):\n    return r ** 2 + 0.3 * q[after, 0] * done"
    )
    assert "never looks at discount" in exercises("lesson_03")["target"](unread).hint


def test_a_question_names_what_is_wrong_with_the_form_of_an_answer():
    number = Question(5.32, "how much", mistakes={"no_gamma": Mistake("γ!", 5.4)})
    assert number("5.32").hint.startswith("the right number, but as text")
    assert "brackets" in number([5.32]).hint
    assert "rounded" in number(5.3).hint and number(5.4).hint == "γ!"
    assert "sign" in number(-5.32).hint and "per cent" in number(532).hint
    assert number(5.3203) and number(np.float32(5.32)) and not number(5.33)
    letters = Question("ACF", "which", mistakes={"AC": Mistake("and F?", "AC")})
    assert letters("FCA") and letters(["a", "C", "f"]) and letters("A, C and F")
    assert letters(("C", "A")).hint == "and F?" and "quotation marks" in letters(3).hint


@pytest.mark.parametrize(("lesson", "name"), EVERY)
def test_every_exercise_has_three_hints_on_request_and_says_what_is_gained(
    lesson, name
):
    exercise = exercises(lesson)[name]
    hints = [exercise.hint(number).text for number in (1, 2, 3)]
    assert len(set(hints)) == 3 and all(
        exercise.hint(number).status == "hint" for number in (1, 2, 3)
    )
    assert exercise.hint().text == hints[0] and "hint(2) tells more" in hints[0]
    assert "There are 3 hints" in exercise.hint(4).text
    assert len(exercise.gained) > 20


def test_a_verdict_is_a_card_and_shows_nothing_as_html_that_a_learner_has_written():
    verdict = exercises("lesson_03")["target"](lambda *_: "<script>")
    card = verdict._repr_html_()
    assert "Not yet" in card and "&lt;script&gt;" in card and "<script>" not in card
    assert "expected" in card and repr(verdict).startswith("✗ ")


def test_a_page_takes_the_edits_of_another_page_but_not_its_witnesses(tmp_path):
    (tmp_path / "twice.md").write_text(PAGE)
    (tmp_path / "again.md").write_text(
        "# again\n\nonce more\n\n## Mistakes\n\n- those of `twice`\n"
    )
    assert [
        entry[::3] for entry in read_page(tmp_path / "again.md", {"given": 4})[1]
    ] == [("half", [])]


def test_the_example_of_the_package_runs():
    assert doctest.testmod(rlrobot_grading) == doctest.TestResults(0, 6)


def test_a_verdict_has_the_colours_of_the_figures():
    for name in ("BLUE", "GREEN", "GREY", "RED"):
        assert getattr(verdicts, name) == getattr(palette, name)
