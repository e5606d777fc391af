"""Programs with models and plans, variables and tasks."""

from __future__ import annotations

from hypothesis import strategies as st

from fuzz.learning import ACTION, STATE
from fuzz.programs import program
from fuzz.values import call, lines, some, value

ARRAYS = ["-1", "10**9", "nan", "inf", "0", "1", "2**62"]
fields = ["offsets", "s_next", "r", "terminated", "cumulative", "starts", "rewards"]
changes = st.one_of(
    st.builds("{0}=np.where(np.arange(len(model.{0})) == {1}, {2}, model.{0})".format, st.sampled_from(fields),
              st.integers(0, 25), st.sampled_from(ARRAYS)),
    st.builds("{0}=model.{0}{1}".format, st.sampled_from(fields), st.sampled_from([
        "[:-1]", "[:0]", "[::-1]", "[None]", "[..., None]", ".astype(float)", ".astype(complex)", ".astype('U9')",
        ".tolist()",
        ".astype(object)", " * 0", " * 1e308", "[::2]", ".astype('>i8')", ".astype('i2')"])),
    st.builds("{}={}".format, st.sampled_from([*fields, "shape", "n_actions", "unseen", "episode_steps"]), value("1")),
    value("(24,)", "(2, 12)", "(72, 1)", "[2, 2, 3, 2]", "(2, -12)", "(0, 24)", "(2.0, 12)").map("shape={}".format),
    st.sampled_from(["stay", "start", "uniform", "siblings", "nonsense"]).map("unseen={!r}".format),
)  # fmt: skip
planning = program(
    "planning", 8,
    st.one_of(
        st.lists(changes, min_size=1, max_size=2, unique_by=lambda text: text.split("=")[0])
        .map(", ".join).map("made = replace(model, {})".format),
        call("made = rl.SampleModel.from_recording", value("recording"), unseen=value("'stay'", "'start'")),
        st.just("made = model"),
    ),
    "usable_model(made)",
    some(
        call("rl.value_iteration", value("made"), gamma=value("0.9", "0", "1 - 2**-53"),
        tolerance=value("1e-9", "1e-300")),
        call("rl.best_average_reward", value("made")), call("made.diagnose", value("3")),
        call("made.outcomes", STATE, ACTION),
        call("made.sum_by_pair", value("1", "made.r")),
    ),
)  # fmt: skip

number = value()
numbers = value("[0, 1]", "[0.5]", "range(2)") | st.lists(number, max_size=3).map(", ".join).map("[{}]".format)
name, unit, ends = value("'X'", "'theta'"), value("''", "'deg'"), {"low": number, "high": number}
described = st.one_of(
    lines(
        call("variable = rl.InputVariable", name, numbers, unit)
        | call(
            "variable = rl.InputVariable", name, unit=unit, sectors=value("8", "2", "10**7"), values=numbers, **ends
        ),
        some(call("variable.bin", number), call("variable.decode", value("0", "1")), "repr(variable), variable.n_bins"),
        "made = replace(task, inputs=[variable, *task.inputs[2:]])",
    ),
    lines(
        call("variable = rl.OutputVariable", value("'move'"), numbers, unit, words=value("['a', 'b']", "'ab'")),
        "made = replace(task, outputs=[variable])",
    ),
)
variables = program(
    "variables", 8,
    described,
    some(call("made.states.decode", STATE), call("made.states.encode", value("{'X': 0, 'theta': 90, 'd': 0}"))),
    "rl.make_env(made, 0).reset()",
)  # fmt: skip

task_fields = st.builds("{}={}".format, st.sampled_from([
    "robot", "scene", "inputs", "outputs", "reward", "rewards", "command", "step_time", "episode_steps", "goal",
    "goal_steps",
    "name", "path", "description"]), value("1", "'giraff'", "[1, 2]", "lambda *_: nan", "lambda *_: True",
    "raising(SystemExit(1))"))  # fmt: skip
tasks = program(
    "tasks", 8,
    st.lists(task_fields, min_size=1, max_size=2, unique_by=lambda text: text.split("=")[0])
    .map(", ".join).map("made = replace(task, {})".format),
    some(
        call("made.states.decode", STATE), call("made.states.number", value("(0, 0, 0, 0)")),
        call("made.states.siblings", STATE),
        call("made.states.encode", value("{'X': 0, 'Y': 1, 'theta': 90, 'd': 1}", "{'X': nan}")),
        call("made.actions.label", ACTION),
        call("made.actions.encode", value("{'move': 0}")), call("made.command_for", ACTION),
        call("made.actions.decode", ACTION),
        call("made.reward_for", value("{'bumped': 1}"), value("{'bumped': 1}")), "repr(made)", "copy.deepcopy(made)",
        call("rl.load_task", value("made", "'wander_simple'")), "rl.available_tasks()", call("made.states.bins", STATE),
    ),
    "env = rl.make_env(made, 0)",
    "usable_agent(rl.Agent(made), env, 40)",
)  # fmt: skip

TARGETS = [planning, variables, tasks]
