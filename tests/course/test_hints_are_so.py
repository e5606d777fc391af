"""A hint is so: what a check says of a wrong answer is true of it, and following it leads further."""

from __future__ import annotations

import copy
import inspect
import json
import re
from pathlib import Path

import numpy as np
import pytest
from test_checks import EVERY, exercises, learner, some_nightly

from rlrobot_course.exercises.parts import Design
from rlrobot_grading.answers import notebook
from rlrobot_grading.answers.source import uses_chance
from rlrobot_grading.exercises import mistake as mistakes
from rlrobot_grading.exercises.exercise import Exercise
from rlrobot_grading.exercises.question import Question
from rlrobot_grading.hints.as_if import one_change_of
from rlrobot_grading.hints.detectors import DETECTORS
from rlrobot_grading.hints.evidence import Hint
from rlrobot_grading.hints.pieces import SHORT

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"
FUNCTIONS = [one for one in EVERY if isinstance(exercises(one[0])[one[1]], Exercise)]
QUESTIONS = [one for one in EVERY if isinstance(exercises(one[0])[one[1]], Question)]
EXACT = [one for one in FUNCTIONS if not isinstance(exercises(one[0])[one[1]], Design)]

# Mistakes that are given as a whole program although one change makes it: each hint speaks of this change.
SAME_THING = {
    ("assignment_1", "replay", "ends_after_an_end"),
    ("assignment_3", "td_episode", "fades_before_update"),
    ("assignment_3", "td_episode", "no_fading"),
    ("assignment_3", "trace_after", "counts_visits_alone"),
    ("assignment_3", "trace_after", "fades_after_the_last"),
    ("assignment_3", "true_online_episode", "forgets_v_old"),
    ("assignment_3", "true_online_episode", "no_second_line"),
    ("assignment_3", "watkins_update", "visited_pair_cut"),
    ("assignment_4", "drive", "never_heats"),
    ("assignment_4", "near_states", "no_circle"),
    ("assignment_4", "near_states", "several_inputs"),
    ("assignment_5", "verdict", "unpaired"),
    ("lesson_02", "discounted_return", "gamma_is_lost"),  # another has no_gamma
    ("lesson_04", "draw", "looks_before_it_adds"),
    ("lesson_06", "sarsa_learn", "keeps_a_after_reset"),
    ("lesson_06", "sarsa_learn", "moves_before_update"),
    ("lesson_06", "sarsa_learn", "overwrites_the_reset"),
    ("lesson_06", "sarsa_learn", "updates_twice"),
    ("lesson_07", "sarsa_lambda_update", "no_trace"),
    ("lesson_07", "sarsa_lambda_update", "trace_squared"),
    ("lesson_17", "dyna", "never_moves_on"),
    ("lesson_17", "dyna", "no_memory"),
    ("lesson_17", "dyna", "one_pair"),
    ("lesson_17", "dyna", "return_in_the_loop"),
    ("lesson_17", "dyna", "thinks_before_it_remembers"),
    ("lesson_21", "overlaps", "return_in_the_loop"),
}


def told(lesson: str, name: str, source: str, **known: object) -> str:
    """The hint on an answer that is given as source."""
    answer = learner(source)
    answer.__globals__.update(known)
    return exercises(lesson)[name](answer).hint


@pytest.mark.nightly
@pytest.mark.filterwarnings("ignore")
def test_a_mistake_given_as_a_program_is_the_shortest_one_with_its_values():
    found = set()
    for lesson, name in FUNCTIONS:
        exercise = exercises(lesson)[name]
        known = zip(exercise.mistakes, exercise.wrong_functions, strict=True)
        for mistake, wrong in known:
            if not callable(mistake.wrong):
                continue
            seen = exercise.evidence(wrong, exercise.outcomes(wrong))
            if any(seen.shows(one, True) for _, _, one in one_change_of(seen.right)):
                found.add((lesson, name, mistake.id))
    assert found <= SAME_THING


PLAIN_SUMS = (
    "return sum(rewards)",
    "return rewards[0] + answer(rewards[1:], gamma) if rewards else 0",
)


@pytest.mark.parametrize("body", PLAIN_SUMS)
def test_who_forgets_gamma_is_told_so_and_not_that_it_changes(body):
    hint = told(
        "lesson_02", "discounted_return", f"def answer(rewards, gamma):\n    {body}"
    )
    assert hint.startswith("γ is missing")


def called_by_their_own_name():
    for lesson, name in FUNCTIONS:
        for lender in exercises(lesson)[name].lenders:
            yield lesson, name, lender
        yield lesson, name, "max"


@pytest.mark.parametrize(
    ("lesson", "name", "function"), list(called_by_their_own_name())
)
def test_a_value_named_like_the_function_it_comes_of_is_told(lesson, name, function):
    names = ["before", "after"]
    if not isinstance(exercises(lesson)[name], Design):
        names = exercises(lesson)[name].parameters
    given = ", ".join(names)
    hint = told(
        lesson,
        name,
        f"def answer({given}):\n    {function} = {function}({names[0]})\n    return {function}",
    )
    assert f"{function} is the name of a value" in hint and "another name" in hint


def test_a_value_that_hides_a_function_is_told_where_it_is_called():
    source = "def answer(q, r, s_next, end, gamma):\n    max = 0\n    return r + gamma * max(q[s_next])"
    assert "max is the name of a value" in told("lesson_03", "target", source)


def test_a_sum_that_is_added_to_before_it_has_a_value_is_told_so():
    source = "def answer(rewards, gamma):\n    for r in rewards:\n        sum += r\n    return sum"
    hint = told("lesson_02", "discounted_return", source)
    assert hint.startswith("sum is used before it has a value")


NOT_TWO = {
    "the same thing done twice": ("lesson_04", "draw", """
def answer(p, u):
    total = 0
    for a in reversed(range(len(p))):
        total += p[a]
        if total > 1 - u:
            return a
"""),
    "no such sign": ("lesson_04", "draw", """
def answer(p, u):
    total = 0
    for a in np.argsort(p)[::-1]:
        total += p[a]
        if total > u:
            return int(a)
"""),
    "a shorter way": ("lesson_01", "bin_of", "def answer(x, cuts):\n    return int(np.argmax(cuts))"),
    "a result that is not seen": ("lesson_01", "bin_of", "def answer(x, cuts):\n    return cuts[0]"),
    "contradictory": ("lesson_15", "p_value", "def answer(observed, shuffled):\n    return sum(shuffled)"),
}  # fmt: skip


@pytest.mark.parametrize("why", NOT_TWO)
def test_two_things_at_once_are_not_said_where_they_are_not(why):
    assert "two things" not in told(*NOT_TWO[why])


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize(("lesson", "name"), some_nightly(EXACT))
def test_nothing_is_said_of_all_cases_if_one_stops_with_an_error(lesson, name):
    exercise = exercises(lesson)[name]
    last = max(i for i, right in enumerate(exercise.expected) if not right.failure)
    calls = []

    def answer(*arguments):
        calls.append(1)
        if len(calls) % len(exercise.cases) == (last + 1) % len(exercise.cases):
            raise ValueError
        value = exercise.right(*copy.deepcopy(arguments))
        return 2 * np.asarray(value, dtype=float)

    hint = exercise(answer).hint
    assert not re.search("always|every case|all cases", hint), hint


def test_who_uses_an_argument_is_not_told_that_it_is_one():
    source = """
def answer(first, second, t):
    low, high = interval(np.subtract(sorted(first), sorted(second)), t)
    return "first" if low > 0 else "second" if high < 0 else "open"
"""
    right = inspect.getmodule(exercises("assignment_5")["verdict"].right)
    hint = told("assignment_5", "verdict", source, interval=right.interval)
    assert "t is an argument" not in hint and "“t”" not in hint


def test_a_table_that_is_made_anew_is_told_with_what_cures_it():
    source = """
def answer(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    best = 0 if terminated else q[s_next].max()
    greedy = not terminated and q[s_next, a_next] == best
    e[s, a] = 1
    q += alpha * (r + gamma * best - q[s, a]) * e
    if greedy:
        e *= gamma * lam
    else:
        e = np.zeros_like(e)
"""
    hint = told("assignment_3", "watkins_update", source)
    assert "makes a new array" in hint and "e[:] = …" in hint
    cured = source.replace("e = np", "e[:] = np")
    assert exercises("assignment_3")["watkins_update"](learner(cured))


@pytest.mark.long
@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize(("lesson", "name"), some_nightly(EXACT))
def test_no_line_of_the_solution_is_told_to_who_has_not_written_it(lesson, name):
    exercise = exercises(lesson)[name]
    mutants = [mutant for _, _, mutant in one_change_of(exercise.right)]
    unseen = [one for one in mutants if one.__code__.co_filename[0] == "<"]
    for mutant in unseen[:: len(unseen) // 12 + 1]:
        seen = exercise.evidence(mutant, exercise.outcomes(mutant))
        if not seen.wrong:
            continue
        hint = DETECTORS["one_change"](seen)
        for piece in re.findall("“([^”]*)”", hint):
            assert len(piece) <= SHORT, hint
            names = set(re.findall(r"[^\W\d]\w*", piece))
            assert names.isdisjoint(exercise.lenders), hint


@pytest.mark.parametrize(("lesson", "name"), QUESTIONS)
def test_a_formula_is_told_in_symbols_of_the_lesson_and_in_numbers(lesson, name):
    formula = exercises(lesson)[name].formula
    if formula is None:
        return
    path = next(NOTEBOOKS.rglob(f"{lesson[-2:]}_*.ipynb"))
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    text = " ".join("".join(cell["source"]) for cell in cells)
    for change in formula.changes:
        for piece in re.findall("“([^”]*)”", change.said):
            for symbol in re.findall(r"[^\W\d]\w*", piece):
                assert len(symbol) == 1, change.said
                assert symbol in text or LATEX[symbol] in text, change.said


LATEX = {
    "α": r"\alpha",
    "γ": r"\gamma",
    "δ": r"\delta",
    "ε": r"\varepsilon",
    "λ": r"\lambda",
}


def test_a_round_number_is_not_told_by_a_far_fetched_change():
    assert "twice" not in exercises("lesson_12")["targets"]((10.0, 100.0)).hint


def spoilt_arguments():
    """Each argument that can be changed in place and should only be read."""
    for lesson, name in EXACT:
        exercise = exercises(lesson)[name]
        for argument in exercise.parameters:
            kinds = np.ndarray | list | dict | set
            can_change = [isinstance(case[argument], kinds) for case in exercise.cases]
            if argument not in exercise.memory and any(can_change):
                yield lesson, name, argument


def spoil(thing):
    """Change what is innermost."""
    if isinstance(thing, np.ndarray):
        if thing.dtype.kind in "fiu":
            thing += 1
    elif isinstance(thing, dict):
        for part in thing.values():
            spoil(part)
        thing["more"] = 1
    elif isinstance(thing, set):
        thing.add("more")
    elif isinstance(thing, list):
        for part in thing:
            spoil(part)
        if not any(isinstance(part, np.ndarray) for part in thing):
            thing.append(thing[0] if thing else 0)


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize(("lesson", "name", "argument"), list(spoilt_arguments()))
def test_to_copy_as_the_hint_says_cures_what_is_spoilt(lesson, name, argument):
    exercise = exercises(lesson)[name]
    given = ", ".join(exercise.parameters)
    source = """
def answer({}):
    result = solution(*copy.deepcopy([{}]))
    {}
    spoil({})
    return result
"""
    if exercise.memory:
        source = source.replace("*copy.deepcopy([{}])", "{}")

    def judged(line):
        answer = learner(source.format(given, given, line, argument))
        answer.__globals__.update(solution=exercise.right, spoil=spoil, copy=copy)
        return exercise(answer)

    verdict = judged("pass")
    assert verdict.id == "spoilt", verdict
    remedy = re.search(r"as in (.+?)(; or write|, with import copy)", verdict.hint)
    assert remedy and judged(remedy[1]), verdict


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize(("lesson", "name"), EXACT)
def test_a_number_of_fewer_digits_is_told_by_numbers_that_differ(lesson, name):
    exercise = exercises(lesson)[name]
    if not exercise.returns or type(exercise) is not Exercise:
        return

    def answer(*arguments):
        value = exercise.right(*arguments)
        is_real = np.asarray(value).dtype.kind == "f"
        return np.asarray(value, dtype=np.float32) if is_real else value

    verdict = exercise(answer)
    rows = [row for row in verdict.rows if row[1]]
    assert all(expected != got for _, expected, got in rows), verdict
    if not exercise.memory:
        assert verdict or "float32" in verdict.hint, verdict


@pytest.mark.parametrize(("lesson", "name"), QUESTIONS)
def test_a_decimal_comma_is_told(lesson, name):
    question = exercises(lesson)[name]
    if isinstance(question.right, str) or np.ndim(question.right):
        return
    assert "a point, not a comma" in question((0, 5)).hint
    assert "a point, not a comma" in question(0, 5).hint


@pytest.mark.parametrize("lost", ["epsilon", "1 − epsilon"])
def test_shares_that_lack_a_part_are_told_which(lost):
    part = {"epsilon": "1 - epsilon", "1 − epsilon": "epsilon"}[lost]
    source = f"def answer(q_s, epsilon):\n    best = q_s == q_s.max()\n    return ({part}) * best / best.sum()"
    assert f"the part {lost} is missing" in told("lesson_04", "epsilon_greedy", source)


def test_who_returns_a_list_of_none_is_not_told_of_infinity():
    assert "None" in exercises("assignment_2")["who"]([1, None, 2, 3]).hint


def test_a_set_where_a_list_is_asked_is_told_in_good_grammar():
    hint = told(
        "lesson_05", "siblings", "def answer(shape, s, i):\n    return set(shape)"
    )
    assert hint.startswith("a set stands here") and "list" in hint


def test_pythons_own_bin_and_a_difference_of_dictionaries_are_told():
    assert "Python's own" in told(
        "lesson_01", "bin_of", "def answer(x, cuts):\n    return bin(x)"
    )
    assert "dictionary" in told(
        "lesson_01", "reward", "def answer(before, after):\n    return after - before"
    )


def test_random_numbers_that_are_given_are_no_chance():
    assert not uses_chance(learner("def answer(rng):\n    return rng.random()"))
    assert uses_chance(learner("def answer(x):\n    return np.random.random()"))
    assert uses_chance(learner("def answer(x):\n    import random\n    return random"))


class Shell:
    """What `told_if_slow` needs of IPython's shell."""

    def __init__(self):
        self.kernel, self.display_pub, self.said = self, self, []

    def publish(self, data, transient, update=False):
        self.said.append((data["text/plain"], update))


@pytest.mark.parametrize("seconds", [0.0, 60.0])
def test_a_check_that_takes_long_says_that_it_works(seconds, monkeypatch):
    shell = Shell()
    monkeypatch.setattr(notebook, "shell", lambda: shell)
    monkeypatch.setattr(notebook, "AT_ONCE", seconds)
    monkeypatch.delenv("RLROBOT_EDU_PROGRESS", raising=False)
    with notebook.told_if_slow("working"):
        for _ in range(200):
            if seconds or shell.said:
                break
            notebook.threading.Event().wait(0.05)
    assert shell.said == ([] if seconds else [("working", False), ("", True)])


SARSA = """
def answer(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    {}
    for _ in range(steps):
"""
LOOPS = {
    "an update that comes late": (
        SARSA.format("old = None")
        + """
        s_next, r, terminated, truncated = env.step(a)
        if old is not None:
            update(q, *old, s, a, False)
        old = s, a, r
        a_next = choose(q, s_next)
        if terminated or truncated:
            update(q, s, a, r, s_next, a_next, terminated)
            s, old = env.reset(), None
            a_next, s_next = choose(q, s), s
        s, a = s_next, a_next
""",
        "update too late: it is due after choose, and env.step comes first. At the very end it is missing",
    ),
    "an end that is looked at half; that nothing is chosen there does no harm": (
        SARSA.format("")
        + """
        s_next, r, terminated, truncated = env.step(a)
        if not terminated:
            a_next = choose(q, s_next)
            update(q, s, a, r, s_next, a_next, terminated)
        s, a = s_next, a_next
        if terminated or truncated:
            s = env.reset()
            a = choose(q, s)
""",
        "after env.step yours calls env.reset, where update is due",
    ),
    "arguments by name, in another order": (
        SARSA.format("")
        + """
        s_next, r, terminated, truncated = env.step(a)
        a_next = choose(s=s_next, q=q)
        update(q, terminated=terminated, a_next=a_next, s_next=s_next, s=s, a=a, r=-r)
        s, a = s_next, a_next
        if terminated or truncated:
            s = env.reset()
            a = choose(q, s)
""",
        "in call 1 of update, r is -10 and should be 10",
    ),
}


@pytest.mark.parametrize("which", LOOPS)
def test_of_a_loop_the_first_call_that_does_harm_is_told(which):
    source, said = LOOPS[which]
    assert said in told("lesson_06", "sarsa_learn", source)


UNKNOWN = {
    "fall": ("lesson_06", "fall", 0.77),
    "softmax": (
        "lesson_04",
        "softmax",
        "def answer(x, temperature):\n    return np.cos(x * temperature + 0.3)",
    ),
}


@pytest.mark.parametrize("which", UNKNOWN)
def test_each_wrong_answer_without_a_known_cause_is_shown_the_way_to_hints(
    which, monkeypatch
):
    lesson, name, answer = UNKNOWN[which]
    if isinstance(answer, str):
        answer = learner(answer)
    monkeypatch.setattr(mistakes, "is_notebook", lambda: True)
    check = exercises(lesson)[name]
    monkeypatch.setattr("rlrobot_grading.exercises.exercise.is_notebook", lambda: True)
    monkeypatch.setattr(type(check), "hint_on", lambda *_: Hint("", ""), raising=False)
    for _ in range(2):
        verdict = check(answer)
        assert f"write check.{name}.hint()" in verdict.text
        assert verdict.id in ("", mistakes.FIRST_STEP)
    monkeypatch.setenv("RLROBOT_EDU_HINTS", "0")
    assert "hint()" not in check(answer).text, "homework may have none"
    assert not check(answer).hint


def test_a_recognised_mistake_needs_no_further_way(monkeypatch):
    monkeypatch.setattr(mistakes, "is_notebook", lambda: True)
    verdict = exercises("lesson_06")["fall"](0.975**11)
    assert verdict.hint and "hint()" not in verdict.text


IN_NUMBERS = [
    one for one in QUESTIONS if not isinstance(exercises(one[0])[one[1]].right, str)
]


@pytest.mark.parametrize(("lesson", "name"), IN_NUMBERS)
def test_a_question_in_numbers_has_a_first_step_that_tells_no_number_of_the_answer(
    lesson, name
):
    question = exercises(lesson)[name]
    absurd = -987654.321 * np.ones(np.shape(question.right))
    verdict = question(absurd.tolist())
    assert verdict.hint == question.first_step != ""
    assert verdict.id == mistakes.FIRST_STEP
    numbers = [float(n) for n in re.findall(r"\d+(?:\.\d+)?", question.first_step)]
    whole = np.ndim(question.right) and all(type(n) is int for n in question.right)
    for right in np.ravel(question.right):
        # of whole numbers the range is told, in which they lie
        assert whole or not np.isclose(numbers, right, rtol=0.02).any()
    assert not question.equals(numbers, question.right)


def test_the_letters_of_an_answer_are_not_told_one_by_one():
    question = exercises("lesson_09")["heats"]
    hints = {question(letters).hint for letters in ("AF", "CF", "AC", "ABCF", "ACDF")}
    assert len(hints) == 4, "what is to be looked at is told, not in which letter"
    for hint in hints:
        assert not re.search(r"\b[A-E]\b", hint)


def test_of_several_numbers_it_is_not_told_how_many_are_right():
    question = exercises("lesson_11")["bins"]
    hints = {question(five).hint for five in ((1, 2, 0, 3, 3), (0, 1, 1, 0, 0))}
    assert hints == {question.first_step}


@pytest.mark.parametrize("divided", ["", " / temperature"])
def test_shares_without_an_exponential_are_told_so(divided):
    source = f"def answer(x, temperature):\n    y = (x - x.min()){divided}\n    return y / y.sum()"
    assert told("lesson_04", "softmax", source).startswith("the exponential is missing")
