"""A call that comes naturally works, or one sentence of ours says what to write instead."""

import importlib
import inspect
import re
import traceback
from pathlib import Path
from pkgutil import resolve_name

import gymnasium
import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.learning.algorithms.sarsa import SARSA
from rlrobot_edu.learning.history import History
from rlrobot_edu.learning.selections.greedy import EG
from rlrobot_edu.missing_names import ELSEWHERE, ONCE
from rlrobot_edu.tools.drawing import draw_room
from rlrobot_edu.tools.new_task import new_task
from rlrobot_edu.widgets.driving.teaching import learn_from
from rlrobot_ros import RobotLink, recording_from_bag

QUIET = {"progress": False}
FEW = {**QUIET, "n_jobs": 1, "steps": 10}
# These pass some of their keywords on, so they look at them later.
PASSING = {
    "make_env": lambda **named: rl.make_env("wander_simple", **named),
    "compare": lambda **named: rl.compare("wander_simple", ["Q+SR"], **named),
    "repeat": lambda **named: rl.repeat("wander_simple", "Q+SR", **named),
}
OURS = {"rlrobot_edu", "rlrobot_ros"}
REFUSALS = (
    ValueError,
    FileNotFoundError,
    ImportError,
    IsADirectoryError,
    gymnasium.error.Error,
)


def environment():
    return rl.make_env("wander_simple", seed=0)


def agent():
    return rl.Agent("wander_simple", "Q+EG", seed=0)


# Keywords


# Nobody makes these by hand.
RETURNED = {"RobotEnv", "Runs", "Step"}


def public_things():
    """What `rlrobot_edu` offers, and what it names in other modules of the library, by name."""
    for name in rl.__all__:
        yield name, getattr(rl, name)
    for name, module in ELSEWHERE.items():
        is_course = module.startswith("rlrobot_course")
        thing = getattr(importlib.import_module(module), name)
        if name not in RETURNED and not is_course and has_options(thing):
            yield name, thing


def public_calls():
    """Each public function and class, and each method of theirs that has options, by name."""
    for name, thing in public_things():
        yield name, thing
        if inspect.isclass(thing):
            for key, method in inspect.getmembers(thing, inspect.isroutine):
                is_ours = str(getattr(method, "__module__", "")).startswith("rlrobot")
                if not key.startswith("_") and is_ours and has_options(method):
                    yield f"{name}.{key}", method


def has_options(call):
    parameters = inspect.signature(call).parameters.values()
    return any(parameter.default is not parameter.empty for parameter in parameters)


def keywords():
    """Each public call and each of its keywords that is long enough to be misspelt."""
    for name, call in public_calls():
        for parameter in inspect.signature(call).parameters.values():
            is_named = parameter.kind in (
                parameter.KEYWORD_ONLY,
                parameter.POSITIONAL_OR_KEYWORD,
            )
            if is_named and len(parameter.name) >= 3 and parameter.name != "self":
                yield pytest.param(call, parameter.name, id=f"{name}-{parameter.name}")


@pytest.mark.parametrize(("call", "keyword"), list(keywords()))
def test_a_slip_in_a_keyword_is_answered_with_the_right_one(call, keyword):
    call = PASSING.get(call.__name__, call)
    middle = len(keyword) // 2
    for slip in (keyword + keyword[-1], keyword[:middle] + "q" + keyword[middle:]):
        with pytest.raises((TypeError, ValueError), match=f"did you mean '{keyword}'"):
            call(**{slip: None})


@pytest.mark.parametrize("parameter", ["alpha", "temperature", "planning_steps"])
def test_a_slip_in_a_parameter_of_the_agent_is_answered_wherever_one_is_given(
    parameter,
):
    slip = {parameter[:-1]: 1}
    for call in (
        lambda: rl.Agent("wander_simple", **slip),
        lambda: rl.repeat("wander_simple", "Q+SR", 1, **FEW, **slip),
        lambda: rl.compare("wander_simple", ["Q+SR"], 1, **FEW, **slip),
        lambda: rl.compare("wander_simple", {"x": {"method": "Q+SR", **slip}}, 1),
        lambda: agent().change(**slip),
    ):
        with pytest.raises((TypeError, ValueError), match=f"mean '{parameter}'"):
            call()


def test_arguments_that_are_missing_are_named_with_other_ways_to_make_the_thing():
    recording = rl.read_recording("wander_simple")
    with pytest.raises(TypeError, match=r"offsets, .*SampleModel\.from_recording or"):
        rl.SampleModel(recording)
    with pytest.raises(TypeError, match=r"needs source; Recording\.from_rows or"):
        rl.Recording([(0, 0, 10, 0)])


def test_what_is_public_keeps_its_signature_and_can_be_copied_to_another_process():
    assert "lam" in inspect.signature(rl.Agent).parameters
    assert inspect.getdoc(rl.learn).startswith("Let `agent` learn")
    assert rl.learn.__module__ == "rlrobot_edu.learning.loop"


# Arguments of a wrong kind


@pytest.fixture(scope="module")
def calls(tmp_path_factory):
    """Calls that work, by name: the function and all its arguments."""
    folder = tmp_path_factory.mktemp("calls")
    recording = rl.read_recording("wander_simple")
    model = rl.SampleModel.from_recording(recording)
    history = rl.learn(agent(), environment(), steps=20, **QUIET)
    result = rl.compare(model, ["Q+SR", "Q+EG"], 2, **FEW)
    task = rl.load_task("wander_simple")
    pair = {"agent": agent(), "env": environment()}
    length = {"steps": 3, "episodes": None}
    recording.save(folder / "recording")
    agent().save(folder / "agent.npz")
    stepper = rl.Stepper(agent(), environment())
    parts = {"algorithm": "Q", "selection": "EG", "planner": None}
    return {
        "make_env": (rl.make_env, {"task": model, "seed": 0}),
        "make_env of a task": (
            rl.make_env,
            {"task": task, "seed": 0, "engine": None, "realism": None}
            | {"render_mode": None, "link": None},
        ),
        "compare": (
            rl.compare,
            {"world": model, "methods": ["Q+SR"], "repetitions": 1, "steps": 10}
            | {"seed": 0, "n_jobs": 1, "store": None, "share": (1, 1)},
        ),
        "repeat": (
            rl.repeat,
            {"world": model, "method": "Q+SR", "repetitions": 1, **FEW},
        ),
        "Comparison": (rl.Comparison, {"world": model, "runs": dict(result)}),
        "Comparison.only": (lambda label: result.only(label), {"label": "Q+SR"}),
        "Agent": (
            rl.Agent,
            {"world": task, "method": "Q+EG", "alpha": 0.1, "traces": "full"}
            | {"accumulating": False, "planner": None, "planning_steps": 3, "seed": 0},
        ),
        "Agent.begin_episode": (agent().begin_episode, {"s": 0}),
        "Agent.save": (agent().save, {"path": folder / "again.npz"}),
        "Agent.load": (rl.Agent.load, {"path": folder / "agent.npz"}),
        "Algorithm": (
            lambda **fields: rl.Method(SARSA._replace(**fields), "EG"),
            {"name": "X", "update": SARSA.update, "on_policy": True},
        ),
        "Selection": (
            lambda **fields: rl.Method("Q", EG._replace(**fields)),
            {"name": "X", "is_softmax": False, "is_biased": False},
        ),
        "Method": (rl.Method, parts),
        "learn": (rl.learn, {**pair, **length}),
        "evaluate": (rl.evaluate, {**pair, **length}),
        "steps": (rl.steps, {**pair, "steps": 3}),
        "record": (rl.record, {**pair, **length}),
        "film": (rl.film, {**pair, "steps": 3}),
        "watch": (rl.watch, {**pair, "steps": 3, "speed": 100}),
        "Stepper": (rl.Stepper, {**pair, "at": 1, "keep": 9}),
        "Stepper.forward": (stepper.forward, {"n": 1}),
        "Stepper.back": (stepper.back, {"n": 1}),
        "Stepper.jump": (stepper.jump, {"t": 1}),
        "Stepper.save": (stepper.save, {"path": folder / "page.html", "steps": 2}),
        "read_recording": (
            rl.read_recording,
            {"path": folder / "recording", "task": None, "inputs": None},
        ),
        "Recording": (
            rl.Recording,
            {"transitions": recording.transitions, "source": recording.source},
        ),
        "Recording.save": (recording.save, {"folder": folder / "again"}),
        "Recording.load": (rl.Recording.load, {"path": folder / "recording"}),
        "from_recording": (rl.SampleModel.from_recording, {"recording": recording}),
        "model.save": (model.save, {"path": folder / "model.npz"}),
        "value_iteration": (rl.value_iteration, {"model": model, "gamma": 0.9}),
        "Realism": (rl.Realism, {"laser_noise": 0.0, "delay": 0}),
        "plot_learning": (
            lambda histories, labels: rl.plot_learning(histories, labels=labels),
            {"histories": history, "labels": ["mine"]},
        ),
        "plot_scene": (rl.plot_scene, {"scenes": environment(), "ax": None}),
        "load_task": (rl.load_task, {"task": "wander_1k"}),
        "InputVariable": (rl.InputVariable, {"name": "x", "cuts": [0.2], "unit": "m"}),
        "OutputVariable": (rl.OutputVariable, {"name": "x", "values": [0, 1]}),
        "playground": (rl.playground, {"path": None, "task": "wander_1k"}),
        "stage": (rl.stage, {"path": None}),
        "History.load": (History.load, {"path": folder / "no_such_file.npz"}),
        "new_task": (new_task, {"name": "mine", "folder": folder}),
        "learn_from": (learn_from, {"agent": agent(), "recording": recording}),
        "draw_room": (draw_room, {"text": "+--+\n|R |\n+--+", "cell": 0.6}),
        "RobotLink": (
            RobotLink,
            {"address": "ws://robot:9090", "odom": "odom", "chassis": None}
            | {"max_speed": 0.1, "mounting": (0, 0, 0, False)},
        ),
        "recording_from_bag": (
            recording_from_bag,
            {"path": folder / "no.bag", "task": "wander_1k", "tolerance": 0.1},
        ),
    }


NAMES = [
    "make_env", "make_env of a task", "compare", "repeat", "Comparison", "Comparison.only", "Agent",
    "Agent.begin_episode", "Agent.save", "Agent.load", "Algorithm", "Selection", "Method", "learn", "evaluate", "steps",
    "record", "film", "watch", "Stepper", "Stepper.forward", "Stepper.back", "Stepper.jump", "Stepper.save",
    "read_recording", "Recording", "Recording.save", "Recording.load", "from_recording", "model.save",
    "value_iteration", "Realism", "plot_learning", "plot_scene", "load_task", "InputVariable", "OutputVariable",
    "playground", "stage", "History.load", "new_task", "learn_from", "draw_room", "RobotLink", "recording_from_bag",
]  # fmt: skip


@pytest.mark.parametrize("name", NAMES)
def test_an_argument_of_a_wrong_kind_is_refused_in_a_sentence_of_ours(
    calls, name, tmp_path, monkeypatch
):
    monkeypatch.chdir(tmp_path)  # some take a text for the name of a file
    call, arguments = calls[name]
    for argument in arguments:
        for wrong in (object(), 1j, 1.5, ["a"], {"x": 1}, "text", agent(), int):
            try:
                call(**{**arguments, argument: wrong})
            except REFUSALS as refusal:
                sentence = str(refusal)
                last = traceback.extract_tb(refusal.__traceback__)[-1]
                is_ours = OURS.intersection(Path(last.filename).parts)
                where = f"{argument}={wrong!r:.50}: {sentence}"
                assert is_ours and sentence and "\n" not in sentence, where


def test_the_table_of_calls_is_the_list_of_their_names(calls):
    assert list(calls) == NAMES


# Whole numbers of NumPy


@pytest.mark.parametrize("kind", [np.int8, np.uint8, np.int32, np.int64, np.uint64])
def test_a_whole_number_of_numpy_counts_as_pythons_own(kind, tmp_path):
    def learned(number):
        model = rl.SampleModel.from_recording(rl.read_recording("navigation_1k"))
        new = rl.Agent(model, "Q+EG", seed=number(3), planning_steps=number(2))
        env = rl.make_env(model, seed=number(4))
        history = rl.learn(new, env, episodes=number(2), **QUIET)
        rl.learn(new, env, steps=number(90), episodes=number(1), **QUIET)
        rl.evaluate(new, env, number(90), **QUIET)
        result = rl.compare(
            model, ["Q+EG"], number(2), episodes=number(2), seed=number(3),
            n_jobs=number(1), share=(number(1), number(2)), store=tmp_path / number.__name__, **QUIET,
        )  # fmt: skip
        return [new.q, history.rewards, *(its.rewards for its in result["Q+EG"])]

    for one, other in zip(learned(int), learned(kind), strict=True):
        assert np.array_equal(one, other)


@pytest.mark.parametrize("kind", [np.uint8, np.uint64])
def test_the_stepper_and_films_take_whole_numbers_of_numpy(kind):
    stepper = rl.Stepper(agent(), environment(), at=kind(3), keep=kind(9))
    stepper.forward(kind(2))
    stepper.back(kind(1))
    stepper.jump(kind(5))
    assert stepper.t == 5
    assert len(rl.film(agent(), environment(), kind(3)).frames) == 3


@pytest.mark.parametrize("wrong", [[1], float("inf"), 0, 1.5, "all", True])
def test_a_number_of_cores_that_is_none_is_refused(wandered, wrong):
    with pytest.raises(ValueError, match="n_jobs must be a number of cores"):
        rl.repeat(wandered, "Q+SR", 1, steps=5, n_jobs=wrong, **QUIET)


@pytest.fixture(scope="module")
def wandered():
    return rl.SampleModel.from_recording(rl.read_recording("wander_simple"))


# One meaning


def test_each_view_of_a_robot_takes_an_environment_or_a_scene(wandered):
    pytest.importorskip("meshcat", reason="3D views need meshcat")
    env = environment()
    scene = env.unwrapped.robot.scene()
    limited = gymnasium.wrappers.TimeLimit(env, 5)
    for view in (rl.plot_scene, rl.meshcat):
        assert repr(view(env)) == repr(view(limited)) == repr(view(scene))
        with pytest.raises(
            ValueError, match="no robot to look at: give an environment"
        ):
            view(rl.make_env(wandered))


def test_an_agent_is_made_for_whatever_an_environment_is_made_of(wandered):
    def function():
        return gymnasium.make("FrozenLake-v1")

    spec = gymnasium.spec("CliffWalking-v1")
    for world in ("CliffWalking-v1", spec, function, wandered, "wander_simple"):
        env = rl.make_env(world)
        new = rl.Agent(world, "Q+EG")
        assert len(rl.learn(new, env, 5, **QUIET)) == 5


def test_an_id_of_gymnasium_without_its_version_is_answered_with_the_whole_id():
    for call in (rl.Agent, rl.make_env):
        with pytest.raises(ValueError, match="did you mean 'CliffWalking-v1'"):
            call("CliffWalking")


def test_only_what_can_step_is_told_about_the_old_gym():
    class OldEnvironment:
        def step(self, action):
            return 0, 0.0, False, {}

    with pytest.raises(ValueError, match="shimmy"):
        rl.Agent(OldEnvironment())
    with pytest.raises(ValueError, match=r"got int$"):
        rl.Agent(3)


def test_a_time_limit_of_gymnasium_is_told_where_it_belongs(wandered):
    for world in ("wander_simple", wandered):
        with pytest.raises(ValueError, match=r"gymnasium\.wrappers\.TimeLimit"):
            rl.make_env(world, max_episode_steps=50)


def test_several_methods_are_told_to_go_to_compare():
    with pytest.raises(ValueError, match=r"one method.*rl\.compare takes several"):
        rl.repeat("wander_simple", ["Q+SR", "Q+EG"], 1, **FEW)


def test_a_method_that_a_comparison_does_not_have_is_answered_with_the_nearest(
    wandered,
):
    result = rl.compare(wandered, ["Q+SR", "Q+EG"], 1, **FEW)
    with pytest.raises(KeyError, match=r"did you mean 'Q\+SR'"):
        result["Q+SRR"]
    assert result.get("Q+SRR") is None and "Q+SRR" not in result


# Names


def imported(name):
    """What the import of a name says."""
    with pytest.raises(ImportError) as said:
        exec(f"from rlrobot_edu import {name}", {})
    return str(said.value)


@pytest.mark.parametrize("name", ["Agnet", "History", "LiveView", "shard", "no_name"])
def test_an_import_of_a_name_says_what_the_name_itself_would(name):
    with pytest.raises(AttributeError) as said:
        getattr(rl, name)
    assert imported(name) == str(said.value)


@pytest.mark.parametrize("name", sorted(ONCE))
def test_a_name_that_the_library_had_once_is_answered_with_what_does_the_same_today(
    name,
):
    said = imported(name)
    assert f"no name '{name}' any more; " in said
    for package, inner in re.findall(r"(rl|rlrobot_\w+|Recording)\.([\w.]+)", said):
        assert resolve_name(f"{PACKAGES.get(package, package)}.{inner}"), said


PACKAGES = {"rl": "rlrobot_edu", "Recording": "rlrobot_edu.Recording"}


@pytest.mark.parametrize(
    ("statement", "says"),
    [
        ("import rlrobot_edu.course.lesson_02", "lessons are in rlrobot_course"),
        ("from rlrobot_edu.ros import recording_from_bag", "are in rlrobot_ros$"),
        ("import rlrobot_edu.learning.histroy", r"did you mean 'history'\?"),
        ("from rlrobot_edu.learning import Agent", r"did you mean 'agent'\?"),
        ("import rlrobot_edu.show.scenes", "rlrobot_edu/show/__init__.py says what is"),
    ],
)
def test_an_import_of_a_module_that_has_moved_says_where_to_look(statement, says):
    with pytest.raises(ModuleNotFoundError, match=says):
        exec(statement, {})


def test_of_other_packages_python_says_what_it_always_says():
    with pytest.raises(ModuleNotFoundError, match=r"^No module named 'rlrobot_educ'$"):
        importlib.import_module("rlrobot_educ")
