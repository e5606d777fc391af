"""The kernels as JavaScript: node beside plain Python, with the same numbers drawn."""

import json
import math
import os
import shutil
import subprocess
import sys
from contextlib import suppress
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import rlrobot_edu as rl
from rlrobot_edu.learning.compiled_loop import make_run
from rlrobot_edu.learning.memory import NOW, SETTINGS, new_memory
from rlrobot_edu.learning.methods import SELECTIONS, parse_method
from rlrobot_edu.learning.parameters import Parameters
from rlrobot_edu.learning.step import begin_episode, make_step
from rlrobot_edu.models.sampling import begin, outcome
from rlrobot_edu.robots.arenas import ARENAS
from rlrobot_edu.robots.chassis import PIONEER
from rlrobot_edu.robots.engines.kinematic.base import Body, walls_of
from rlrobot_edu.robots.engines.kinematic.motion import drive, look
from rlrobot_edu.widgets.javascript.program import program
from rlrobot_edu.widgets.playground.page import METHODS as IN_THE_PLAYGROUND
from rlrobot_edu.widgets.stepper.symbols import SYMBOLS

DRIVERS = Path(__file__).parents[1] / "javascript"
# what pages offer: the playground's methods, and a stepper's algorithms with the toolkit's selections
ON_STEPPERS = ("SR", "QBIASSR", "EG", "EGLE", "GREEDY", "RANDOM")
METHODS = [f"{a}+{s}" for a in SYMBOLS for s in ON_STEPPERS]
N_STEPS, MODEL = 5000, "wander_1k"

pytestmark = pytest.mark.skipif(
    shutil.which("node") is None, reason="node is missing: it runs JavaScript"
)


class Worker:
    """A process that answers each line with a line; one that has ended is started anew for the next question."""

    def __init__(self, *command, **surroundings):
        self.command, self.surroundings = command, {**os.environ, **surroundings}
        self.process = None

    def ask(self, job):
        if self.process is None:
            self.process = subprocess.Popen(
                self.command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                text=True,
                env=self.surroundings,
            )
        answer = ""
        with suppress(BrokenPipeError):
            self.process.stdin.write(json.dumps(job) + "\n")
            self.process.stdin.flush()
            answer = self.process.stdout.readline()
        if not answer:
            pytest.fail(self.end())
        return json.loads(answer)

    def end(self):
        """End the process, if there is one; returns why it has ended before, in its own words."""
        if self.process is None:
            return ""
        with suppress(BrokenPipeError):
            self.process.stdin.close()
        self.process.stdout.close()
        with self.process.stderr as errors:
            said = errors.read()[-2000:]
        code, self.process = self.process.wait(60), None
        return f"{self.command[0]} ended with code {code}: {said}" if code else ""


@pytest.fixture(scope="module")
def node():
    worker = Worker("node", str(DRIVERS / "node.js"))
    yield worker
    assert worker.end() == ""


@pytest.fixture(scope="module")
def plain():
    worker = Worker(sys.executable, str(DRIVERS / "plain.py"), NUMBA_DISABLE_JIT="1")
    yield worker
    assert worker.end() == ""


def test_a_worker_that_dies_says_why_and_the_next_question_has_a_new_one():
    worker = Worker("node", str(DRIVERS / "node.js"))
    job = {"kind": "call", "method": "one", "name": "one", "arguments": []}
    with pytest.raises(pytest.fail.Exception, match="no number of JavaScript's"):
        program = '({one: () => { throw new Error("no number of JavaScript\'s"); }})'
        worker.ask(job | {"program": program})
    assert worker.ask(job | {"program": "({one: () => 1})"}) == 1
    assert worker.end() == ""


@pytest.mark.parametrize("method", IN_THE_PLAYGROUND)
def test_the_playground_offers_only_what_these_tests_compare(method):
    assert method in METHODS


@cache
def text_of(name):
    """The kernels of a method: `select`, `learn_step`, `begin_episode`; and `run`, its loop in a sample model."""
    method = parse_method(name)
    step = make_step(method)
    return program(
        {
            "select": step.select,
            "learn_step": step.learn_step,
            "begin_episode": begin_episode,
            "run": make_run(method, begin, outcome),
        }
    )


def memory_of(shape, n_actions, parameters):
    """A new memory in lists and numbers."""
    m = new_memory(shape, n_actions, Parameters(**parameters))
    lists = {
        name: array.tolist()
        for name, array in m._asdict().items()
        if name not in ("parameters", "now")
    }
    records = {"parameters": (m.parameters, SETTINGS), "now": (m.now, NOW)}
    return lists | {
        name: {
            number: np.asarray(getattr(record, number)).item() for number in dtype.names
        }
        for name, (record, dtype) in records.items()
    }


def both(node, plain, job, **more):
    """What came of a job in JavaScript, and in Python."""
    m = memory_of(tuple(job["shape"]), job["n_actions"], job["parameters"])
    ours = plain.ask(job)
    return node.ask(
        {**job, "program": text_of(job["method"]), "memory": m, **more}
    ), ours


def is_drawn_by_exponentials(method):
    return SELECTIONS[method.partition("+")[2]].is_softmax


def same_but_for_exponentials(method, theirs, ours):
    """Arithmetic is equal to the bit; an exponential may differ by its last digit, and probabilities by some of these.

    Where the algorithm learns from probabilities, so may Q.
    """
    looser = is_drawn_by_exponentials(method)
    if looser and method.startswith("ESARSA"):
        np.testing.assert_allclose(theirs["q"], ours["q"], rtol=1e-9, atol=1e-12)
    else:
        assert theirs["q"] == ours["q"]
    assert theirs["e"] == ours["e"] and theirs["visits"] == ours["visits"]
    assert theirs["temperature"] == ours["temperature"]
    if looser:
        np.testing.assert_allclose(
            theirs["probabilities"], ours["probabilities"], rtol=1e-12
        )
    else:
        assert theirs["probabilities"] == ours["probabilities"]


numbers = st.floats(-10, 10, allow_subnormal=False)
shares = st.floats(0.01, 0.99)


@st.composite
def jobs(draw):
    """A tape of transitions in a small world, for any method."""
    shape, n_actions = (
        draw(st.lists(st.integers(1, 4), min_size=1, max_size=3)),
        draw(st.integers(1, 4)),
    )
    s, a = st.integers(0, int(np.prod(shape)) - 1), st.integers(0, n_actions - 1)
    row = st.tuples(s, a, numbers, s, st.booleans(), st.floats(0, 1, exclude_max=True))
    parameters = {
        "alpha": draw(shares), "gamma": draw(shares), "lam": draw(shares), "epsilon": draw(shares),
        "temperature": draw(st.floats(0.1, 50)), "r_max": draw(st.floats(0.1, 10)),
        "traces": draw(st.sampled_from(["reduced", "full"])), "accumulating": draw(st.booleans()),
        "loop_evasion": draw(st.booleans()),
    }  # fmt: skip
    method, tape = (
        draw(st.sampled_from(METHODS)),
        draw(st.lists(row, min_size=1, max_size=40)),
    )
    return {
        "kind": "steps", "method": method, "shape": shape, "n_actions": n_actions, "parameters": parameters,
        "tape": tape,
    }  # fmt: skip


@pytest.mark.filterwarnings("ignore")
def test_on_any_tape_they_learn_what_plain_python_learns(node, plain):
    @settings(max_examples=150, deadline=None)
    @given(jobs())
    def hold(job):
        theirs, ours = both(node, plain, job)
        same_but_for_exponentials(job["method"], theirs, ours)

    hold()


def run_job(method):
    tables = rl.make_env(
        rl.SampleModel.from_recording(rl.read_recording(MODEL))
    ).unwrapped._tables
    shape = tuple(tables.shape.tolist())
    rng = np.random.default_rng(0)
    job = {
        "kind": "run", "method": method, "model": MODEL, "steps": N_STEPS, "shape": shape,
        "n_actions": tables.n_actions,
        "parameters": {"r_max": 10.0}, "u": rng.random(4 * N_STEPS).tolist(), "v": rng.random(2 * N_STEPS).tolist(),
    }  # fmt: skip
    lists = {
        name: np.asarray(thing).tolist() for name, thing in tables._asdict().items()
    }
    return job, {"tables": lists}


@pytest.mark.parametrize(
    "method",
    [
        m if m in ("TOSL+QBIASSR", "Q+EG") else pytest.param(m, marks=pytest.mark.long)
        for m in METHODS
    ],
)
def test_in_a_sample_model_they_live_the_same_life(node, plain, method):
    job, more = run_job(method)
    theirs, ours = both(node, plain, job, **more)
    assert theirs["rewards"] == ours["rewards"] and theirs["at"] == ours["at"], (
        "step for step"
    )
    same_but_for_exponentials(method, theirs, ours)


def test_an_exponential_is_right_to_its_last_digit_but_one(node):
    @settings(max_examples=50, deadline=None)
    @given(st.lists(st.floats(-700, 0), min_size=1, max_size=50))
    def hold(x):
        many = node.ask(
            {
                "kind": "call",
                "method": "exp",
                "program": EXP,
                "name": "many",
                "arguments": [x],
            }
        )
        ours = np.exp(np.array(x))
        assert (np.abs(np.array(many) - ours) <= np.spacing(ours)).all()

    hold()


EXP = "({many: (x) => x.map(Math.exp)})"


def with_a_dictionary(m, s):
    m.now.q_old = 0.0
    seen = {s: 1}
    return seen


def adds_to_a_row(m, s):
    """Python adds to each number of it; JavaScript would make a text of the array."""
    m.e[s] += 1.0


def counts_a_row(m, s):
    """Python adds the numbers of a row; an array of JavaScript has no sum."""
    return m.visits[s].sum()


def asks_for_a_size(m, s):
    """A number in Python, undefined in JavaScript."""
    return m.visits[s].size


def scales_a_row(m, s):
    q = m.q[s]
    return q * 2.0


def copies_a_row(m, s):
    m.probabilities[:] = m.q[s]


def scales_an_argument(x):
    y = x / x[0]
    return y


def takes_the_last(x):
    return x[-1]


def is_nobodys_word(x):
    return math.erf(x)


def changes_its_counter(n):
    for i in range(n):
        i += 1
    return i


@pytest.mark.parametrize(
    ("kernel", "line", "what"), [
        (with_a_dictionary, 2, "{s: 1}"), (changes_its_counter, 2, "changes its own i"),
        (adds_to_a_row, 2, "m.e[s]”, a whole array as a number"), (is_nobodys_word, 1, "math"),
        (counts_a_row, 2, "m.visits[s].sum()"), (asks_for_a_size, 2, "m.visits[s].size"),
        (scales_a_row, 2, "“q”, a whole array"), (copies_a_row, 1, "“m.q[s]”, a whole array"),
        (scales_an_argument, 1, "“x”, a whole array"), (takes_the_last, 1, "x[-1]"),
    ],
)  # fmt: skip
def test_what_has_no_translation_is_refused_with_file_and_line(kernel, line, what):
    with pytest.raises(ValueError) as error:
        program({"kernel": kernel})
    at = kernel.__code__.co_firstlineno + line
    assert f"test_javascript.py:{at}: " in str(error.value) and what in str(error.value)


def test_the_kinematic_base_drives_alike(node):
    """Into the walls of the maze and along them; a sine may differ by its last digit, and so what follows."""
    body, walls, place = (
        Body.of(PIONEER),
        walls_of(ARENAS["maze_6x6"]),
        np.array([PIONEER.axle, 0.0, 0.0]),
    )
    near, touch, lengths = (
        np.zeros(len(walls), dtype=np.int64),
        np.zeros(7),
        np.zeros(len(body.rays)),
    )
    text, rng = program({"drive": drive, "look": look}), np.random.default_rng(0)
    for _ in range(60):
        motion = [float(rng.uniform(-0.2, 0.2)), float(rng.uniform(-1, 1))]
        world = [
            body.hull.tolist(),
            body.radius,
            body.moment,
            walls.tolist(),
            near.tolist(),
            touch.tolist(),
        ]
        job = {
            "kind": "call",
            "method": "base",
            "program": DROVE.replace("PROGRAM", text),
            "name": "drove",
        }
        theirs = node.ask(
            job
            | {"arguments": [place.tolist(), *motion, 1.0, *world, body.rays.tolist()]}
        )
        drive(
            place, *motion, 1.0, body.hull, body.radius, body.moment, walls, near, touch
        )
        look(place, body.rays, 5.02, walls, lengths)
        np.testing.assert_allclose(theirs, [*place, *lengths], atol=1e-9)


DROVE = """({drove: (place, v, omega, seconds, hull, radius, moment, walls, near, touch, rays) => {
const base = PROGRAM, lengths = rays.map(() => 0);
base.drive(place, v, omega, seconds, hull, radius, moment, walls, near, touch);
base.look(place, rays, 5.02, walls, lengths);
return [...place, ...lengths];
}})"""


def python_division(a, b):
    return a // b, a % b, a / b, -a


def test_division_is_pythons(node):
    text = program({"python_division": python_division})
    for a, b in ((7, 2), (-7, 2), (7, -2), (-7, -2), (6, 3), (0.75, 0.5), (-0.75, 0.5)):
        job = {
            "kind": "call",
            "method": "division",
            "program": text,
            "name": "python_division",
            "arguments": [a, b],
        }
        assert node.ask(job) == list(python_division(a, b))


def test_the_text_of_a_method_is_small_and_stands_alone():
    text = text_of("TOSL+QBIASSR")
    assert len(text) < 12_000 and "import" not in text and "require" not in text
