"""What surrounds the library: paths, pictures, a learner's answers, the command line."""

from __future__ import annotations

import importlib

from hypothesis import strategies as st

from fuzz.contract import PACKAGE
from fuzz.learning import METHOD, STATE
from fuzz.programs import given, program
from fuzz.values import ABSURD, HOSTILE, call, some, value

path = value("'nowhere/x.npz'", other=[
    "''", "'.'", "'folder'", "'folder/file'", "'folder/file/x'", "'empty.npz'", "'empty.py'", "'empty.npy'", "'\\0'",
    "'\\ud800'", "None", "3", "b'x'", "'x' * 1500", "Path('.')", "'/dev/null'", "'/dev/zero'", "pipe('pipe.npz')",
    "pipe('pipe.py')", "pipe('pipe.npy')", "pipe('transitions.csv') and '.'", "'wander_simple'", "'~'", "[]", "nan",
    "Odd()", "'x.py'", "'*.npz'",
])  # fmt: skip
out = value(
    "'out.npz'",
    "'out/x'",
    other=[
        "'folder'",
        "'folder/file/x'",
        "''",
        "'.'",
        "'out\\0'",
        "None",
        "3",
        "'x' * 300",
        "Odd()",
        "[]",
    ],
)
inputs = value("None", "['X', 'Y', 'theta', 'd']")
paths = program(
    "paths", 5,
    some(
        *(call(f"rl.{read}", path) for read in ("load_task", "read_recording", "SampleModel.load", "Agent.load")),
        call("rl.read_recording", path, "legacy=True", task=value("task", "'wander_simple'"), inputs=inputs),
        call("rl.read_recording", value("'wander_simple'"), task=value("task")),
        *(call(f"{thing}.save", out) for thing in ("learned", "model", "recording")),
    ),
)  # fmt: skip

words = value(
    "'x'", "'$nope$'", "'$\\\\nope$'", "'_mine'", "'<b>&'", "'a\\nb'", "'é' * 300"
)
tables = value("{'q': np.zeros((24, 3))}", "{'<b>': np.full((24, 3), nan)}")
pictures = program(
    "pictures", 1,
    given(st.just("env = rl.make_env('wander_simple', 0); env.reset(); scene = env.robot.scene()")),
    st.one_of(
        call("made = rl.plot_learning", value("history"), title=words, labels=words.map("[{}]".format)),
        call("made = rl.plot_learning", value("[history, history]"), value("history"), labels=value("['a', '_b']")),
        call("made = rl.plot_scene", value("scene", "[scene, scene]"), ax=value("None"), title=words),
        call("made = rl.film", "rl.Agent('wander_simple')", value("env"), value("2", other=["0", "-1", "nan", "'x'"])),
        call("made = ParameterSliders", value("model"), METHOD, "steps=20", parameters=value("['alpha']")),
        call("made = BiasExplorer", value("task"), tables, state=STATE, temperature=value("1")),
        call("made = rl.Stepper", value("learned"), value("rl.make_env(model, 0)"), at=value("1"), keep=value("5")),
    ),
    "drawn(made)",
)  # fmt: skip


def _exercises() -> list[str]:
    """Every exercise as a call of `check`."""
    from rlrobot_grading.exercises.exercise import Exercise
    from rlrobot_grading.exercises.question import Question

    lessons = sorted(
        path.parent.name
        for path in (PACKAGE.parent / "rlrobot_course").glob("lesson_*/exercises.py")
    )
    rooms = {
        lesson: importlib.import_module(f"rlrobot_course.{lesson}.exercises").check
        for lesson in lessons
    }
    kinds = (Exercise, Question)
    return [
        f"check({r!r}, {n!r})"
        for r, room in rooms.items()
        for n, x in vars(room).items()
        if isinstance(x, kinds)
    ]


odd = value(other=[
    *HOSTILE, *ABSURD, "endless()", "[1] * 10**6", "np.zeros(10**7)", "'x' * 10**7", "[[[1]]] * 3", "np.array('x')",
    "{1: {2: {3: 4}}}", "iter([])", "(x for x in [1])", "np.array([1, [2]], dtype=object)", "np.array([Odd()])",
    "[Odd()]", "(Odd(),)", "10**5000", "Odd(SystemExit)", "[10**400]", "type('T', (), {})", "np.ma.masked",
    "np.timedelta64(3)", "mock.Mock()", "{Odd(): Odd()}", "np.zeros((3, 0))", "'\\x1b[31m'",
])  # fmt: skip
ERRORS = [
    "SystemExit(1)", "RecursionError()", "MemoryError()", "KeyError(3)", "StopIteration()", "GeneratorExit()",
    "Exception(Odd())", "AssertionError('x' * 10**6)", "ValueError('a\\nb')",
]  # fmt: skip
FUNCTIONS = [
    "endless", "recursive", "print", "exit", "len", "max", "lambda: 0", "lambda a, *, b: 0", "lambda f: f(f)", "Odd",
    "np.max", "lambda *a: a", "lambda *a: list(a)", "lambda *a: [x.clear() for x in a if hasattr(x, 'clear')]",
]  # fmt: skip
function = (
    odd.map("lambda *_: {}".format)
    | st.sampled_from(ERRORS).map("raising({})".format)
    | st.sampled_from(FUNCTIONS)
)
checks = program(
    "checks", 8,
    st.builds("verdict = {}({})".format, st.deferred(lambda: st.sampled_from(_exercises())), odd | function),
    "judged(verdict)",
)  # fmt: skip

words = st.lists(st.sampled_from([
    "tasks", "--help", "-h", "", "nonsense", "--quick", "--", "-1", "\0", "é", "\ud800", "x" * 9999,
]), max_size=3)  # fmt: skip
# Not the word alone that starts an hour's work.
words = words | words.map(lambda more: ["grade", "--help", *more])
command_line = program(
    "command_line", 1, words.map(lambda words: f"command_line{tuple(words)!r}")
)

TARGETS = [paths, pictures, checks, command_line]
