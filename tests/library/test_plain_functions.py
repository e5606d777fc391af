"""Plain functions say the same in Python, numba and JavaScript; what is not plain is told by its line."""

import copy
import math
import re
import shutil
from pathlib import Path

import cloudpickle
import numpy as np
import plain_programs
import pytest
from plain_programs import GIVEN_BACK, Drawn, Node, answer, compare, module_of

import rlrobot_edu as rl
from rlrobot_edu.jit.dispatcher import IS_PLAIN
from rlrobot_edu.robots.engines.kinematic.compiled_task import judge_of
from rlrobot_edu.task import plain
from rlrobot_edu.task.plain import NotPlainError, functions_of, plain_text
from rlrobot_edu.task.plain.arithmetic import exact, larger, rounded, smaller
from rlrobot_edu.task.rewards import length
from rlrobot_edu.task.robot_cards import ROBOTS
from rlrobot_edu.task.task_file import available_tasks, load_task
from rlrobot_edu.widgets.javascript.program import rewards_of
from rlrobot_edu.widgets.playground.page import TASKS as IN_THE_PLAYGROUND

NOT_PLAIN = {"worked_example"}  # it compares two places at once
PAGE = Path(__file__).parents[2] / "docs/howto/your_own_task.md"
needs_compiler = pytest.mark.skipif(IS_PLAIN, reason="there is no compiler")


@pytest.fixture(scope="module")
def node():
    """JavaScript; None where node is missing, so that Python's two ways are compared all the same."""
    worker = Node() if shutil.which("node") else None
    yield worker
    if worker:
        worker.close()


def defined(text, **around):
    """The functions of a text amid these names; its first line is line 1."""
    around = {"math": math, "sqrt": math.sqrt, "np": np, "LIMIT": 0.3, **around}
    return module_of(text, around)


def written(text, **around):
    """The reward of a text as a plain function; before, after: readings."""
    reward = defined(text, **around)["reward"]
    return functions_of(plain_text({"reward": reward}, {}))["reward"]


def refused(text, **around):
    """The sentence that says why a text's reward is not plain."""
    with pytest.raises(NotPlainError) as error:
        written(text, **around)
    return re.sub("<.*?>", "own.py", str(error.value))


# the three ways


@pytest.mark.parametrize("seed", range(5))
def test_a_drawn_program_says_the_same_as_a_plain_text_and_in_javascript(node, seed):
    drawn = Drawn(seed)
    for _ in range(20):
        compare(drawn.program(), [drawn.readings_pair() for _ in range(10)], node)


@needs_compiler
@pytest.mark.parametrize(
    "seed", [100, *(pytest.param(i, marks=pytest.mark.long) for i in range(101, 130))]
)
def test_a_drawn_program_says_the_same_compiled(seed):
    drawn = Drawn(seed)
    pairs = [drawn.readings_pair() for _ in range(50)]
    compare(drawn.program(), pairs, is_compiled=True)


def drawn_readings(task, n):
    """So many pairs of readings of a task's robot: usual ones, and edges."""
    drawn, sensors = Drawn(0), ROBOTS[task.robot].sensors
    for _ in range(n):
        share = drawn.rng.choice([0.0, 0.0, 0.3])
        yield [{name: drawn.reading(share) for name in sensors} for _ in range(2)]


@pytest.mark.parametrize("name", sorted(set(available_tasks()) - NOT_PLAIN))
def test_a_task_of_the_toolkit_says_the_same_in_all_ways(name, node):
    task = load_task(name)
    functions = rewards_of(task)
    asked = [("reward", pair) for pair in drawn_readings(task, 400)]
    if task.goal:
        asked += [("goal", pair[1:]) for _, pair in asked]
    own = [answer(getattr(task, what), *given) for what, given in asked]
    said = [answer(functions[what], *given) for what, given in asked]
    for one, other in zip(own, said, strict=True):
        assert other in (one, GIVEN_BACK)
    assert said.count(GIVEN_BACK) < len(said) / 2 and len(set(said)) > 2
    if node:
        assert node.answers(functions, asked) == said


@needs_compiler
@pytest.mark.parametrize(
    "name",
    [
        name if name == "navigation_1k" else pytest.param(name, marks=pytest.mark.long)
        for name in sorted(set(available_tasks()) - NOT_PLAIN)
    ],
)
def test_a_task_of_the_toolkit_says_the_same_compiled(name):
    task = load_task(name)
    judged = plain_programs.Judged(task)
    functions = rewards_of(task)
    goal = functions.get("goal", lambda readings: False)
    for before, after in drawn_readings(task, 400):
        wanted = answer(functions["reward"], before, after), answer(goal, after)
        if GIVEN_BACK in wanted:
            wanted = ("nan", "0.0")
        assert judged.answer(before, after) == wanted


def test_only_the_worked_example_is_not_plain():
    for name in NOT_PLAIN:
        with pytest.raises(NotPlainError, match=rf"{name}.py:\d+: "):
            rewards_of(load_task(name))
    assert not NOT_PLAIN.intersection(IN_THE_PLAYGROUND)


# what is plain

BEFORE, AFTER = {"x": 0.25, "y": -1.5}, {"x": 0.75, "y": -2.5}
REWARD = "def reward(before, after):\n"
ACCEPTED = {
    "a reading": ('after["x"]', "after[X]", "after[(X)]"),
    "a number": ("0.5", "10", "True", "-3", "1e300"),
    "a name for a number": ("LIMIT", "math.pi", "FAR", "IS_ON", "COUNT"),
    "arithmetic": ("LIMIT + 1", "1 - LIMIT", "3 * LIMIT", "1 / 3", "-LIMIT", "+LIMIT"),
    "a comparison": ("(1 < 2) + (2 <= 2)", "1 > LIMIT", "0.1 < LIMIT <= 0.5", "2 != 2.0"),
    "a choice": ("0 or LIMIT", "2 and LIMIT", "not LIMIT", "1 if LIMIT else 2"),
    "a limit": ("abs(-LIMIT)", "min(3, LIMIT, 1)", "max(3, LIMIT)"),
    "a root": ("sqrt(LIMIT)", "math.sqrt(2)"),
    "rounding": ("round(2.5)", "round(3.5)", "round(-0.5)", "round(50 * LIMIT) / 10"),
    "a helper": ("near(after)", "near(after, limit=2)", "near(readings=after, name=X)"),
}  # fmt: skip
STATEMENTS = {
    "a variable": "a = LIMIT\n    b: float = 2\n    b, a = a, b\n    a += 1\n    a -= b\n"
    "    a *= 3\n    a /= 7\n    return a",
    "other statements": '"""Say it."""\n    if LIMIT > 1:\n        return 1\n    elif LIMIT > 2:\n'
    "        pass\n    else:\n        a = 7\n        return a\n    return 5",
}
NEAR = (
    "def near(readings, limit=0.3, *, name='x'):\n    return readings[name] < limit\n"
)


def rows(text):
    """The lines of the table of plain functions."""
    return [line for line in text.splitlines() if line.startswith("| ")]


def test_each_row_of_the_table_is_tried():
    first = [row.split(" | ")[0].strip("| ") for row in rows(plain.__doc__)]
    assert set(first) == {"what", *ACCEPTED, *STATEMENTS}


def test_the_page_for_authors_has_the_same_table():
    page = PAGE.read_text(encoding="utf-8")
    assert "\n".join(rows(plain.__doc__)[1:]) in page


@pytest.mark.parametrize(
    "body",
    [
        *(f"return {value}" for values in ACCEPTED.values() for value in values),
        *STATEMENTS.values(),
    ],
)
def test_what_the_table_lists_is_plain_and_says_the_same(body):
    around = {"X": "x", "FAR": math.inf, "IS_ON": True, "COUNT": 7}
    text = f"{NEAR}{REWARD}    {body}\n"
    own = defined(text, **around)["reward"](BEFORE, AFTER)
    assert repr(written(text, **around)(BEFORE, AFTER)) == repr(float(own) + 0.0)


def test_numbers_and_texts_of_a_closure_are_plain():
    def above(limit, name):
        return lambda before, after: 10 if after[name] > limit else -2

    text = plain_text({"high": above(1, "y"), "low": above(-9, "y")}, {})
    functions = functions_of(text)
    assert functions["high"](BEFORE, AFTER) == -2.0
    assert functions["low"](BEFORE, AFTER) == 10.0


def test_a_function_that_was_sent_to_another_process_is_still_plain():
    reward = load_task("wander_1k").reward
    sent = cloudpickle.loads(cloudpickle.dumps(reward))
    assert plain_text({"reward": sent}, {}) == plain_text({"reward": reward}, {})


def test_names_may_be_words_of_javascript_or_of_the_text_that_is_written(node):
    text = f"{REWARD}    var, function, exact = after['x'], 2, 3\n    reward_0, NaN = 1, 7\n"
    text += "    return var + function + exact + reward_0 + NaN\n"
    pairs = [[{name: 0.5 for name in plain_programs.NAMES}] * 2]
    compare(f"{text}goal = lambda readings: readings['x'] > 0\n", pairs, node)


# what is not

REFUSED = [
    ("a = after['x']\n    return a ** 2", 3, "“a ** 2” is not plain; write x * x"),
    ("return 7 % 2", 2, "“7 % 2” is not plain; compare with limits"),
    ("return 7 // 2", 2, "“7 // 2” is not plain; compare with limits"),
    ("return 1 << 2", 2, "“1 << 2”"),
    ("return ~1", 2, "“~1”"),
    ("return math.hypot(3, 4)", 2, "use length of rlrobot_edu.task.rewards"),
    ("return math.log(2)", 2, "“math.log(2)”"),
    ("return int(2.5)", 2, "use round"),
    ("return float(2)", 2, "leave it out"),
    ("return sum([1, 2])", 2, "write a + b"),
    ("return any(x > 0 for x in (1, 2))", 2, "write a or b"),
    ("return round(0.25, 1)", 2, "as many as the table says"),
    ("return min(1)", 2, "as many as the table says"),
    ("return max((1, 2))", 2, "“(1, 2)”"),
    ("return max(1, 2, key=abs)", 2, "as many as the table says"),
    ("return after.get('x')", 2, "“after.get('x')”"),
    ("return after[LIMIT]", 2, "write the reading's name"),
    ("return after", 2, "a number is needed here"),
    ("r = after\n    return r['x']", 2, "a number is needed here"),
    ("return TABLE[1]", 2, "give each number a name"),
    ("return ARRAY[0]", 2, "give each number a name"),
    ("return (0.0, -2.0)[1]", 2, "give each number a name"),
    ("return NUMPY", 2, "a number of NumPy"),
    ("return 1 + 'a'", 2, "“'a'” is not plain; it is no number, but of type str"),
    ("return None", 2, "of type NoneType"),
    ("return 9007199254740992", 2, "it is too large"),
    ("return NAN", 2, "it is NaN"),
    ("return nobody", 2, "it has no value here"),
    ("if LIMIT:\n        a = 1\n    return a", 4, "it may have no value here"),
    ("if LIMIT:\n        return 1", 1, "may end without a return"),
    ("for i in range(2):\n        pass\n    return 1", 2, "“for i in range(2):”"),
    ("while LIMIT:\n        pass\n    return 1", 2, "“while LIMIT:”"),
    ("global COUNT\n    COUNT = 1\n    return COUNT", 2, "“global COUNT”"),
    ("a = b = 1\n    return a", 2, "“a = b = 1”"),
    ("TABLE[0] = 1\n    return 1", 2, "“TABLE[0]”"),
    ("after['x'] = 1\n    return 1", 2, "“after['x']”"),
    ("after = 1\n    return 1", 2, "another value for “after”"),
    ("print(1)\n    return 1", 2, "“print(1)”"),
    ("import math\n    return math.pi", 2, "“import math”"),
    ("raise ValueError\n    return 1", 2, "“raise ValueError”"),
    ("return (a := 1)", 2, "“(a := 1)”"),
    ("return 1 if after is before else 2", 2, "“after is before”"),
    ("return (after['x'], 1) != (2, 3)", 2, "“(after['x'], 1)”"),
    ("return reward(before, after)", 2, "reward, which calls itself,"),
    ("return near(*after)", 2, "a call with * or **"),
    ("return near(after, **{})", 2, "a call with * or **"),
    ("return near(after, 1, 2, 3)", 2, "too many positional arguments"),
    ("return ((((1 or 2) or 3) or 4) or 5)", 2, "give a part of it a name"),
    ("return np.hypot(3, 4)", 2, "use length"),
]


@pytest.mark.parametrize(("body", "line", "what"), REFUSED)
def test_what_is_not_plain_is_told_by_its_line(body, line, what):
    around = {
        "TABLE": [1, 2], "ARRAY": np.zeros(2), "NUMPY": np.float64(2), "NAN": math.nan,
        "near": defined(NEAR)["near"],
    }  # fmt: skip
    said = refused(f"{REWARD}    {body}\n", **around)
    assert said.startswith(f"own.py:{line}: ") and what in said


@pytest.mark.parametrize(
    ("text", "line", "what"),
    [
        (
            "def reward(before, after, seen=[]):\n    return 1\n",
            1,
            "the default of seen",
        ),
        ("def reward(before):\n    return 1\n", 1, "too many positional arguments"),
        ("def reward(*readings):\n    return 1\n", 1, "*args or **kwargs"),
        ("def reward(before, after):\n    yield 1\n", 1, "a generator"),
        ("async def reward(before, after):\n    return 1\n", 1, "async"),
        (
            "def a(b):\n    return b\n\ndef helper(x):\n    return x ** 2\n"
            "def reward(before, after):\n    return helper(2)\n",
            5,
            "“x ** 2”",
        ),
        (
            "def make():\n    n = 500\n    def reward(before, after):\n        nonlocal n\n"
            "        n -= 1\n        return n\n    return reward\nreward = make()\n",
            4,
            "“nonlocal n”",
        ),
        (
            "a, reward = (lambda b, c: 1), (lambda b, c: 1)\n",
            1,
            "two functions on one line",
        ),
        ("reward = max\n", None, "write a function"),
        (
            "from functools import partial\ndef f(a, b, c):\n    return 1\nreward = partial(f, c=1)\n",
            None,
            "write a function",
        ),
    ],
)
def test_a_function_that_is_not_plain_as_a_whole_is_told_by_its_line(text, line, what):
    said = refused(text)
    assert what in said and (line is None or said.startswith(f"own.py:{line}: "))


def test_what_is_too_long_or_too_deep_is_told():
    deep = " + ".join(["1"] * 2000)
    assert "too much is nested" in refused(f"{REWARD}    return {deep}\n")
    long = "    a = 1\n" * 10_000
    assert "too long" in refused(f"{REWARD}{long}    return a\n")


def test_a_reading_that_the_robot_has_not_is_told():
    reward = defined(f"{REWARD}    return after['lazer']\n")["reward"]
    with pytest.raises(NotPlainError, match=r"2: .*the robot has no such reading"):
        plain_text({"reward": reward}, {}, ["laser_front"])


def test_python_of_the_same_name_is_known_by_what_it_is():
    body = f"{REWARD}    return wurzel(4) + abs(-1)\n"
    assert written(body, wurzel=math.sqrt)(BEFORE, AFTER) == 3.0
    assert "“abs(-1)”" in refused(body, wurzel=math.sqrt, abs=math.log)


def test_a_file_that_has_changed_proves_nothing(tmp_path):
    file = tmp_path / "own.py"
    text = Path(load_task("wander_simple").path).read_text(encoding="utf-8")
    file.write_text(text, encoding="utf-8")
    task = load_task(file)
    assert "0.07" in plain_text({"reward": task.reward}, {})
    file.write_text(text.replace("0.07", "0.0777"), encoding="utf-8")
    again = load_task(file)
    assert "0.0777" in plain_text({"reward": again.reward}, {})
    changed = copy.copy(task.reward)
    plain.source._definitions_in.cache_clear()
    with pytest.raises(NotPlainError, match=r"own.py:\d+: .* has changed"):
        plain_text({"reward": changed}, {})


def test_a_function_without_a_file_is_refused():
    space = {}
    exec("def reward(before, after):\n    return 1.0\n", space)
    with pytest.raises(NotPlainError, match="its text is not there"):
        plain_text({"reward": space["reward"]}, {})


def test_a_task_that_is_not_plain_is_said_once(capsys):
    reward = defined(f"{REWARD}    return 10.0 if after['x'] ** 2 > 1 else -1.0\n")
    like = load_task("wander_1k")
    task = rl.Task(
        like.robot, like.scene, like.inputs, like.outputs, reward["reward"], [10, -1]
    )
    for _ in range(3):
        assert judge_of(task, ROBOTS[task.robot].sensors) is None
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and ":2: “after['x'] ** 2” is not plain" in said


# the arithmetic


def test_rounding_is_pythons():
    rng = np.random.default_rng(0)
    numbers = [*plain_programs.EDGES, *np.linspace(-6, 6, 49).tolist()]
    numbers += (rng.normal(size=2000) * 10.0 ** rng.integers(-5, 16, 2000)).tolist()
    for x in numbers:
        if abs(x) < 2**53:
            assert repr(rounded(x)) == repr(float(round(x)) + 0.0), x
        else:
            with pytest.raises(OverflowError):
                rounded(x)


def test_the_smaller_and_the_larger_are_pythons():
    for a in plain_programs.EDGES:
        for b in plain_programs.EDGES:
            assert repr(smaller(a, b)) == repr(min(a, b))
            assert repr(larger(a, b)) == repr(max(a, b))


def test_whole_numbers_end_where_floats_no_longer_know_each():
    assert exact(2.0**53 - 1) == 2**53 - 1
    for x in (2.0**53, -(2.0**53), math.inf):
        with pytest.raises(OverflowError):
            exact(x)
    assert math.isnan(exact(math.nan))


def test_a_length_is_that_of_hypot_but_for_its_last_bit():
    pairs = np.random.default_rng(0).uniform(-5, 5, (1000, 2))
    for x, y in pairs.tolist():
        assert length(x, y) == pytest.approx(math.hypot(x, y), rel=1e-15, abs=0)
