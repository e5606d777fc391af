"""Programs with models and plans, variables and tasks."""

from __future__ import annotations

from hypothesis import strategies as st

from fuzz.learning import ACTION, STATE
from fuzz.programs import program
from fuzz.values import Text, call, lines, some, value

FIELDS = ["offsets", "s_next", "r", "terminated", "cumulative", "starts", "rewards"]
VIEWS = [
    "[:-1]", "[:0]", "[::-1]", "[None]", "[..., None]", ".astype(float)", ".astype(complex)", ".astype('U9')",
    ".tolist()", ".astype(object)", " * 0", " * 1e308", "[::2]", ".astype('>i8')", ".astype('i2')",
]  # fmt: skip
SHAPES = [
    "(24,)",
    "(2, 12)",
    "(72, 1)",
    "[2, 2, 3, 2]",
    "(2, -12)",
    "(0, 24)",
    "(2.0, 12)",
]
array, number = (
    st.sampled_from(FIELDS),
    st.sampled_from(["-1", "10**9", "nan", "inf", "0", "1", "2**62"]),
)
one_number = "{0}=np.where(np.arange(len(model.{0})) == {1}, {2}, model.{0})"
change = st.one_of(
    st.builds(one_number.format, array, st.integers(0, 25), number),
    st.builds("{0}=model.{0}{1}".format, array, st.sampled_from(VIEWS)),
    st.builds(
        "{}={}".format,
        st.sampled_from([*FIELDS, "shape", "n_actions", "unseen", "episode_steps"]),
        value("1"),
    ),
    st.sampled_from(SHAPES).map("shape={}".format),
    st.sampled_from(["stay", "uniform", "siblings", "nonsense"]).map(
        "unseen={!r}".format
    ),
)


def changed(thing: str, change: Text) -> Text:
    """The thing with one or two of its fields changed gets the name `made`."""
    changes = st.lists(
        change, min_size=1, max_size=2, unique_by=lambda text: text.split("=")[0]
    )
    return changes.map(", ".join).map(f"made = replace({thing}, {{}})".format)


planning = program(
    "planning", 8,
    changed("model", change)
    | call("made = rl.SampleModel.from_recording", value("recording"), unseen=value("'stay'", "'siblings'"))
    | st.just("made = model"),
    "usable_model(made)",
    some(
        call("rl.value_iteration", value("made"), gamma=value("0.9", "0"), tolerance=value("1e-9", "1e-300")),
        call("best_average_reward", value("made")),
        call("made.diagnose", value("3")), call("made.outcomes", STATE, ACTION),
    ),
)  # fmt: skip

number = value()
numbers = value("[0, 1]", "[0.5]", "range(2)") | st.lists(number, max_size=3).map(
    ", ".join
).map("[{}]".format)
name, unit, ends = (
    value("'X'", "'theta'"),
    value("''", "'deg'"),
    {"low": number, "high": number},
)
described = st.one_of(
    lines(
        call("variable = rl.InputVariable", name, numbers, unit)
        | call(
            "variable = rl.InputVariable",
            name,
            unit=unit,
            sectors=value("8", "2", "10**7"),
            values=numbers,
            **ends,
        ),
        some(
            call("variable.bin", number),
            call("variable.decode", value("0", "1")),
            "repr(variable), variable.n_bins",
        ),
        "made = replace(task, inputs=[variable, *task.inputs[2:]])",
    ),
    lines(
        call(
            "variable = rl.OutputVariable",
            value("'move'"),
            numbers,
            unit,
            words=value("['a', 'b']", "'ab'"),
        ),
        "made = replace(task, outputs=[variable])",
    ),
)
variables = program(
    "variables", 8,
    described,
    some(call("made.states.decode", STATE), call("made.states.encode", value("{'X': 0, 'theta': 90, 'd': 0}"))),
    "rl.make_env(made, 0).reset()",
)  # fmt: skip

FIELDS_OF_TASK = [
    "robot", "scene", "inputs", "outputs", "reward", "rewards", "command", "step_time", "episode_steps", "goal",
    "goal_steps", "name", "path", "description",
]  # fmt: skip
anything = value(
    "1",
    "'giraff'",
    "[1, 2]",
    "lambda *_: nan",
    "lambda *_: True",
    "raising(SystemExit(1))",
)
readings = value("{'X': 0, 'Y': 1, 'theta': 90, 'd': 1, 'bumped': 1}", "{'X': nan}")
tasks = program(
    "tasks", 8,
    changed("task", st.builds("{}={}".format, st.sampled_from(FIELDS_OF_TASK), anything)),
    some(
        *(call(f"made.states.{ask}", STATE) for ask in ("decode", "siblings", "bins")),
        *(call(f"made.{ask}", ACTION) for ask in ("actions.label", "actions.decode", "command_for")),
        call("made.states.number", value("(0, 0, 0, 0)")), call("made.states.encode", readings),
        call("made.reward_for", readings, readings),
        call("rl.load_task", value("made", "'wander_simple'")), "repr(made)", "copy.deepcopy(made)",
        "available_tasks()",
    ),
    "env = rl.make_env(made, 0)",
    "usable_agent(rl.Agent(made), env, 40)",
)  # fmt: skip

TARGETS = [planning, variables, tasks]
