"""The typed face: to mypy and to an editor the public names are what they are, not Any."""

import ast
import importlib
import re
import subprocess
import sys
from pathlib import Path
from typing import get_args

import pytest
from mypy import api

import rlrobot_edu as rl
from rlrobot_edu.installing import to_install
from rlrobot_edu.missing_names import ELSEWHERE
from rlrobot_edu.task.robot_cards import ROBOTS, Engine

ROOT = Path(__file__).parents[2]
STUB = ROOT / "rlrobot_edu" / "__init__.pyi"
CONTRACT = {
    "Agent", "Comparison", "Realism", "Recording", "SampleModel",
    "Stepper", "Task", "compare", "film", "learn", "load_task", "make_env", "plot_learning", "plot_scene",
    "read_recording", "record", "repeat", "steps", "value_iteration",
}  # fmt: skip
FACE = """
import rlrobot_edu as rl
from rlrobot_edu.robots.robot_env import RobotEnv

task = rl.load_task("wander_1k")
agent = rl.Agent(task, "TOSL+QBIASSR", seed=0)
reveal_type(task)
reveal_type(agent)
reveal_type(rl.learn(agent, rl.make_env(task), steps=10))
reveal_type(rl.read_recording("wander_1k"))
reveal_type(rl.SampleModel.from_recording(rl.read_recording("wander_1k")))
reveal_type(rl.compare(task, ["Q+SR"], 2, steps=10))
reveal_type(rl.compare(task, ["Q+SR"])["Q+SR"][:5])
reveal_type(rl.film(agent, rl.make_env(task, engine="kinematic", render_mode="rgb_array")))
rl.plot_learning(rl.learn(agent, rl.make_env(task), steps=10)).savefig("curve.png")
rl.compare("CliffWalking-v1", ["Q+SR"]).plot().savefig("curves.png")
for step in rl.steps(agent, rl.make_env(task), steps=10):
    reveal_type(step)
rl.no_such_name
rl.make_env(task, engine="steam")
rl.compare(task, ["Q+SR"], 2, steps=10, engine="steam")
RobotEnv(task, render_mode="human")
"""


def test_the_stub_holds_every_name_of_the_contract_and_each_can_be_had():
    imports = [
        node
        for node in ast.parse(STUB.read_text()).body
        if isinstance(node, ast.ImportFrom)
    ]
    names = {alias.asname for node in imports for alias in node.names}
    assert names >= CONTRACT
    assert names == set(rl.__all__)
    for name in names:
        assert getattr(rl, name).__module__.startswith("rlrobot_edu."), name


@pytest.mark.long
def test_to_mypy_an_agent_is_an_agent_and_an_unknown_name_is_an_error(
    tmp_path, monkeypatch
):
    (tmp_path / "face.py").write_text(FACE)
    monkeypatch.chdir(ROOT)  # where mypy's settings are
    said, trouble, _ = api.run([str(tmp_path / "face.py")])
    types = re.findall(
        r'Revealed type is ".*?rlrobot_edu\.[\w.]+\.(\w+)\W*"', said
    )  # a tuple names its class last
    assert types == [
        "Task",
        "Agent",
        "History",
        "Recording",
        "SampleModel",
        "Comparison",
        "Runs",
        "Film",
        "Step",
    ], said + trouble
    assert 'has no attribute "no_such_name"' in said and said.count("error:") == 4, said
    assert (
        said.count("incompatible type \"Literal['steam']\"") == 2
        and "Literal['human']" in said
    ), said


def test_there_are_few_public_names():
    assert len(rl.__all__) <= 30


@pytest.mark.parametrize("name", sorted(ELSEWHERE))
def test_a_name_that_is_elsewhere_is_there_and_the_answer_says_so(name):
    module = ELSEWHERE[name]
    assert name not in rl.__all__ and not hasattr(rl, name)
    with pytest.raises(
        AttributeError, match=f"^{name} is in {module}: from {module} import {name}$"
    ):
        getattr(rl, name)
    assert hasattr(importlib.import_module(module), name)


def test_a_misspelt_name_is_answered_with_the_nearest_one():
    with pytest.raises(AttributeError, match="'Agnet'; did you mean 'Agent'"):
        rl.Agnet  # noqa: B018
    with pytest.raises(AttributeError, match="did you mean 'History'"):
        rl.Histroy  # noqa: B018
    with pytest.raises(ImportError, match="'lern'; did you mean 'learn'"):
        from rlrobot_edu import lern  # noqa: F401
    assert getattr(rl, "xyzzy", None) is None


WITHOUT_MESHCAT = """
import inspect, sys
sys.modules["meshcat"] = None  # importing it fails
import rlrobot_edu as rl
from rlrobot_edu import *
assert {name for name, _ in inspect.getmembers(rl)} >= set(rl.__all__) <= set(dir(rl))
assert hasattr(rl, "meshcat") and Agent is rl.Agent
try:
    meshcat(make_env("wander_simple"))
except ImportError as error:
    print(error)
"""


def test_all_names_can_be_walked_where_an_extra_is_missing():
    done = subprocess.run(
        [sys.executable, "-c", WITHOUT_MESHCAT], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    assert f"3D views need meshcat: run {to_install('notebook')}" in done.stdout


def test_the_engines_have_the_names_that_the_robots_cards_have():
    assert set(get_args(Engine)) == {
        engine for card in ROBOTS.values() for engine in card.engines
    }
