"""Two different programs never count as one, and one program counts as one in every process and every folder."""

import importlib
import os
import pickle
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import cloudpickle
import pytest

import rlrobot_edu as rl
from rlrobot_edu.experiments.compare import facts_of
from rlrobot_edu.files import shipped
from rlrobot_edu.jit.dispatcher import IS_PLAIN, compiled
from rlrobot_edu.jit.fingerprint import code_of
from rlrobot_edu.learning.methods import made_of

# A program whose `f` is looked at, a text in it, and what stands there in another program
# ruff: noqa: E501
PAIRS = {
    "a constant": ("K = 0.5\ndef f(x): return K * x", "0.5", "0.1"),
    "a whole number or a float": ("K = 1\ndef f(x): return K * x", "K = 1", "K = 1.0"),
    "the sign of zero": ("K = 0.0\ndef f(x): return K * x", "0.0", "-0.0"),
    "a default": ("def f(x, k=1): return k * x", "k=1", "k=2"),
    "a default by keyword": ("def f(x, *, k=1): return k * x", "k=1", "k=2"),
    "how arguments are given": ("def f(x, k=1): return k * x", "x, k", "x, *, k"),
    "the name of an argument": ("def g(a=1, b=2): return a\ndef f(x): return g(b=x)", "a=1, b=2", "b=2, a=1"),
    "an attribute's name": ("def f(x): return x.real", "real", "imag"),
    "an order": ("def f(x): return x < 1", "<", ">"),
    "a helper": ("def g(x): return x + 1\ndef f(x): return g(x)", "+", "-"),
    "a helper's constant": ("K = 1\ndef g(x): return x + K\ndef f(x): return g(x)", "K = 1", "K = 2"),
    "a global of a function inside": ("K = 1\ndef f(x):\n    def g(): return K\n    return g() * x", "K = 1", "K = 2"),
    "a global of a comprehension": ("K = 1\ndef f(x): return [K for _ in x]", "K = 1", "K = 2"),
    "what encloses it": ("def make(k):\n    def f(x): return k * x\n    return f\nf = make(1)", "make(1)", "make(2)"),
    "a list": ("K = [1, [2]]\ndef f(x): return K", "[2]", "[3]"),
    "a mapping": ("K = {'a': 1}\ndef f(x): return K", "1", "2"),
    "a set": ("K = {'a', 'b', 'c'}\ndef f(x): return x in K", "'c'", "'d'"),
    "a set that is a constant": ("def f(x): return x in {'a', 'b', 'c'}", "'c'", "'d'"),
    "an entry of a long table": (
        "import numpy as np\nK = np.zeros(2000)\nK[1000] = 1\ndef f(x): return K[x]", "= 1", "= 2"
    ),
    "the ninth digit of a table": ("import numpy as np\nK = np.array([0.1])\ndef f(x): return K", "0.1", "0.100000001"),
    "the type of a table": ("import numpy as np\nK = np.zeros(4, 'f8')\ndef f(x): return K", "f8", "i8"),
    "the shape of a table": ("import numpy as np\nK = np.zeros((2, 3))\ndef f(x): return K", "2, 3", "3, 2"),
    "a part of a partial": (
        "from functools import partial\ndef g(x, k): return x * k\nf = partial(g, k=1)", "k=1", "k=2"
    ),
    "the function of a partial": (
        "from functools import partial\ndef g(x, k): return x * k\nf = partial(g, k=1)", "x * k", "x / k"
    ),
    "a method": (
        "class C:\n    k = 1\n    def g(self, x): return x + 1\nc = C()\ndef f(x): return c.g(x)", "x + 1", "x + 2"
    ),
    "a constant of a class": ("class C:\n    k = 1\ndef f(x): return C.k", "k = 1", "k = 2"),
    "a number of an object": (
        "class C:\n    def __init__(self, k): self.k = k\nc = C(1)\ndef f(x): return c.k", "C(1)", "C(2)"
    ),
    "a method bound to an object": (
        "class C:\n    def __init__(self, k): self.k = k\n    def g(self, x): return self.k\nf = C(1).g", "C(1)", "C(2)"
    ),
    "an object that is called": (
        "class C:\n    def __init__(self, k): self.k = k\n    def __call__(self, x): return self.k\nf = C(1)", "C(1)", "C(2)"
    ),
    "the class above a class": (
        "class A:\n    def g(self): return 1\nclass B(A): pass\ndef f(x): return B().g()", "return 1", "return 2"
    ),
    "a property": ("class C:\n    @property\n    def g(self): return 1\nc = C()\ndef f(x): return c.g", "return 1", "return 2"),
    "a static method": ("class C:\n    @staticmethod\n    def g(): return 1\ndef f(x): return C.g()", "return 1", "return 2"),
    "a class method": ("class C:\n    @classmethod\n    def g(cls): return 1\ndef f(x): return C.g()", "return 1", "return 2"),
    "a field of a dataclass": (
        "from dataclasses import dataclass\n@dataclass\nclass C:\n    k: int = 1\ndef f(x): return C().k", "= 1", "= 2"
    ),
    "a named tuple": (
        "from typing import NamedTuple\nclass C(NamedTuple):\n    k: int = 1\ndef f(x): return C().k", "= 1", "= 2"
    ),
    "a word of an enumeration": ("from enum import Enum\nclass C(Enum):\n    A = 1\ndef f(x): return C.A.value", "= 1", "= 2"),
    "a function that keeps its results": (
        "from functools import cache\n@cache\ndef g(x): return x + 1\ndef f(x): return g(x)", "+ 1", "+ 2"
    ),
    "a function that is wrapped": (
        "from functools import wraps\ndef twice(g):\n    @wraps(g)\n    def h(x): return g(g(x))\n    return h\n"
        "@twice\ndef f(x): return x + 1", "+ 1", "+ 2"
    ),
    "what wraps it": (
        "from functools import wraps\ndef twice(g):\n    @wraps(g)\n    def h(x): return g(g(x))\n    return h\n"
        "@twice\ndef f(x): return x + 1", "g(g(x))", "g(x)"
    ),
    "what wraps it, from a library": (
        "from contextlib import contextmanager\n@contextmanager\ndef f(x): yield x + 1", "+ 1", "+ 2"
    ),
    "a function with a library's name": (
        "import functools, math\n@functools.wraps(math.sin)\ndef f(x): return x + 1", "+ 1", "+ 2"
    ),
    "an attribute of a function": ("def g(x): return g.k\ng.k = 1\ndef f(x): return g(x)", "g.k = 1", "g.k = 2"),
    "functions in a list": ("K = [lambda x: x, lambda x: x + 1]\ndef f(x): return K[0](x)", "x + 1", "x + 2"),
    "one of two functions in a line": ("g = (lambda x: x + 1, lambda x: x + 2)\nf = g[0]", "g[0]", "g[1]"),
    "a module of another name": ("import math as lib\ndef f(x): return lib.sqrt(x)", "math", "cmath"),
    "a function of another module": ("from math import sqrt\ndef f(x): return sqrt(x)", "from math", "from cmath"),
    "a function of numpy": ("from numpy import exp as g\ndef f(x): return g(x)", "exp", "expm1"),
    "recursion": ("def f(x): return 1 if x < 1 else x * f(x - 1)", "x * f", "x + f"),
    "functions that call one another": (
        "def g(x): return x > 0 and f(x - 1)\ndef f(x): return x < 0 or g(x - 2)", "x - 2", "x - 3"
    ),
    "what a compiler may do": (
        "try:\n    from numba import njit\nexcept ImportError:\n    def njit(**_): return lambda g: g\n"
        "def f(x): return x + 1\nf = njit(fastmath=False)(f), False", "False", "True"
    ),
}  # fmt: skip


def made(program):
    space = {"__name__": "__main__"}
    exec(program, space)
    return code_of(space["f"])


@pytest.mark.parametrize("pair", PAIRS)
def test_two_programs_have_two_names(pair):
    program, old, new = PAIRS[pair]
    assert program.count(old) >= 1
    assert made(program) == made(program) == made("\n\nOTHER = 1\n" + program)
    assert made(program.replace(old, new)) != made(program)


def test_things_that_know_one_another_are_read_once():
    program = """
class Node: pass
nodes = [Node() for _ in range(60)]
for node in nodes: node.all, node.others = nodes, set(nodes)
def f(): return nodes
"""
    assert made(program) != made(program.replace("60", "61"))


NAMES = """
import sys
from test_identity import PAIRS, code_of, made, rl
print({pair: made(program) for pair, (program, _, _) in PAIRS.items()})
"""


def in_another_process(script, *folders, seed="1", **environment):
    """What a script prints in a process with another order of sets, whose working folder is the first one."""
    paths = os.pathsep.join(map(str, folders))
    environment = {
        **os.environ,
        "PYTHONHASHSEED": seed,
        "PYTHONPATH": paths,
        **environment,
    }
    run = subprocess.run(
        [sys.executable, "-c", script, folders[0]],
        env=environment,
        cwd=folders[0],
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stderr
    return run.stdout.strip()


@pytest.mark.long
def test_a_program_has_one_name_in_every_process_and_every_folder(tmp_path):
    here = str({pair: made(program) for pair, (program, _, _) in PAIRS.items()})
    for seed in "12":
        (folder := tmp_path / f"folder {seed}").mkdir()
        shutil.copy(__file__, folder)
        assert in_another_process(NAMES, folder, seed=seed) == here


@pytest.mark.parametrize("pair", PAIRS)
def test_a_program_that_was_sent_to_another_process_keeps_its_name(pair):
    space = {"__name__": "__main__"}
    exec(PAIRS[pair][0], space)
    try:
        again = cloudpickle.loads(cloudpickle.dumps(space["f"]))
    except pickle.PicklingError as error:
        pytest.skip(f"it cannot be sent: {error}")
    assert code_of(again) == code_of(space["f"])


# Modules


@pytest.fixture
def module(tmp_path, monkeypatch):
    """A function that writes a module of the learner's and imports it anew."""
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(sys, "dont_write_bytecode", True)

    def write(name, text):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(textwrap.dedent(text), encoding="utf-8")
        for loaded in [
            loaded
            for loaded in sys.modules
            if loaded.partition(".")[0].startswith("own_")
        ]:
            monkeypatch.delitem(sys.modules, loaded)
        importlib.invalidate_caches()

    return write


@pytest.mark.parametrize(
    "program",
    [
        "import own_helper\ndef f(x): return own_helper.g(x)",
        "import own_helper as h\ndef f(x): return h.g(x)",
        "from own_helper import g\ndef f(x): return g(x)",
        "def f(x):\n    import own_helper\n    return own_helper.g(x)",
        "def f(x):\n    from own_helper import g\n    return g(x)",
        "import own_package.deep\ndef f(x): return own_package.deep.own_helper.g(x)",
        "from own_package import deep\ndef f(x):\n    h = deep.own_helper\n    return h.g(x)",
        "from own_package.deep import own_helper\nclass C:\n    def g(self, x): return own_helper.g(x)\n"
        "def f(x): return C().g(x)",
    ],
)
def test_an_edit_in_a_module_is_seen_however_the_module_is_reached(program, module):
    names = set()
    for factor in (1, 2, 1):
        module("own_package/__init__.py", "")
        module("own_package/deep.py", "import own_package, own_helper")
        module("own_helper.py", f"K = {factor}\ndef g(x): return K * x\n")
        names.add(made(program))
    assert len(names) == 2


def test_what_a_function_does_not_ask_for_does_not_change_its_name(module):
    names = set()
    for other in (1, 2):
        module(
            "own_helper.py",
            f"OTHER = {other}\ndef g(x): return x\ndef unused(x): return {other}\n",
        )
        names.add(
            made(f"import own_helper\nq = {other}\ndef f(m): return own_helper.g(m.q)")
        )  # q is no global here
    assert len(names) == 1


# Stores and saved agents


def method_of(program, **kind):
    """A method whose update, or whatever `kind` says, is `f` of a program."""
    space = {"__name__": "__main__", "compiled": compiled}
    exec(program, space)
    return rl.Method(rl.Algorithm("MINE", space["f"], **kind), "SR")


UPDATE = """
K = 0.5
def g(x):
    return x + 1
def f(m, s, a, r, s_next, a_next, terminated):
    m.q[s, a] += K
    return 0.0
def unused(m):
    return g(m)
"""
CHANGES = {
    "a constant": (UPDATE, "K = 0.5", "K = 0.1", {}),
    "the code": (UPDATE, "+= K", "-= K", {}),
    "a helper": (UPDATE.replace("+= K", "+= g(K)").replace("def g", "@compiled\ndef g"), "x + 1", "x + 2", {}),
    "a flag": (UPDATE, "K", "K", {"on_policy": False}),
}  # fmt: skip


@pytest.mark.parametrize("change", CHANGES)
def test_neither_a_store_nor_a_saved_agent_takes_a_changed_method_for_the_same(
    change, wander_model, tmp_path
):
    program, old, new, flags = CHANGES[change]

    def run(method):
        about = {"repetitions": 1, "steps": 5, "progress": False, "n_jobs": 1}
        return rl.compare(wander_model, [method], store=tmp_path / "store", **about)[
            "MINE+SR"
        ][0].q.sum()

    first = run(method_of(program))
    assert run(method_of(program)) == first
    rl.Agent(wander_model, method_of(program)).save(tmp_path / "agent.npz")
    rl.Agent.load(tmp_path / "agent.npz", method_of(program))
    other = method_of(program.replace(old, new), **flags)
    with pytest.raises(ValueError, match="another experiment: the code of MINE"):
        run(other)
    with pytest.raises(
        ValueError, match="is not the one that was given: the code of MINE"
    ):
        rl.Agent.load(tmp_path / "agent.npz", other)


TOOLKITS = """
import pickle
from test_identity import made_of
print(made_of(pickle.loads(bytes.fromhex("{}"))))
"""


def test_the_toolkits_parts_are_not_own_ones_in_whatever_process():
    method = rl.Method("Q", "SR", "dyna")
    folders = (Path(__file__).parent,)
    assert (
        made_of(method)
        == made_of(pickle.loads(pickle.dumps(method)))
        == {"planner": "dyna"}
    )
    assert (
        in_another_process(TOOLKITS.format(cloudpickle.dumps(method).hex()), *folders)
        == "{'planner': 'dyna'}"
    )
    impostor = rl.Method(
        rl.Algorithm("Q", rl.Method("SARSA", "SR").algorithm.update), "SR"
    )
    assert [*made_of(impostor)] == ["planner", "the code of Q"]


@pytest.mark.parametrize(
    "make",
    [
        lambda: rl.Agent("wander_simple", planner="dyna"),
        lambda: rl.Method("Q", "SR", "dyna"),
    ],
)
def test_what_plans_can_be_pickled(make):
    again = pickle.loads(pickle.dumps(make()))
    assert repr(again) == repr(make())


# Tasks


TASK = """
import sys
from pathlib import Path
import own_helper
import rlrobot_edu as rl
OTHER = own_helper

def reward(before, after):
    return OTHER.g(after["laser_front"])

task = rl.Task(
    robot="mobile_base", scene="square_2x2",
    inputs=[rl.InputVariable("laser_front", cuts=[0.3], unit="m")],
    outputs=[rl.OutputVariable("left_wheel", values=[1.0], unit="rad/s"),
             rl.OutputVariable("right_wheel", values=[1.0, -1.0], unit="rad/s")],
    rewards=[1.0, -1.0], reward=reward,
)
"""


def test_a_store_sees_an_edit_in_a_file_that_the_tasks_file_imports(module, tmp_path):
    (tmp_path / "own_task.py").write_text(TASK, encoding="utf-8")
    facts = []
    for limit in (0.5, 0.6, 0.5):
        module(
            "own_helper.py",
            f"LIMIT = {limit}\ndef g(x): return 1.0 if x > LIMIT else -1.0\n",
        )
        facts.append(facts_of(rl.load_task(tmp_path / "own_task.py")))
    assert facts[0] == facts[2]
    assert [name for name in facts[0] if facts[0][name] != facts[1][name]] == [
        "the function reward"
    ]


FACTS = """
import sys
from test_identity import facts_of, rl
from rlrobot_edu.task.task_file import available_tasks
print(*(facts_of(rl.load_task(name)) for name in available_tasks()), sep="; ")
"""


@pytest.mark.long
def test_the_facts_of_the_toolkits_tasks_are_the_same_in_every_process():
    facts = {
        in_another_process(FACTS, Path(__file__).parent, seed=seed) for seed in "12"
    }
    assert len(facts) == 1


def test_another_function_of_the_same_file_is_another_one(tmp_path, module):
    module("own_helper.py", "def g(x): return 1.0")
    text = TASK.replace(
        "task = ", "def other(before, after):\n    return 1.0\n\ntask = "
    )
    (tmp_path / "own_task.py").write_text(text, encoding="utf-8")
    task = rl.load_task(tmp_path / "own_task.py")
    names = {
        code_of(task.reward.__globals__[name], file=task.path)
        for name in ("reward", "other")
    }
    assert len(names) == 2


# Kernels


LEARN = """
import sys
import rlrobot_edu as rl
assert rl.__file__.startswith(sys.argv[1]), rl.__file__
agent = rl.Agent("worked_example", "Q+GREEDY", planner="dyna", planning_steps=5, loop_evasion=False, seed=0)
rl.learn(agent, rl.make_env("worked_example", seed=0), steps=30, progress=False)
print(agent.q.tolist())
"""


@pytest.mark.long
@pytest.mark.skipif(IS_PLAIN, reason="needs kernels that are compiled")
def test_an_edited_algorithm_runs_in_real_and_in_imagined_steps_alike(tmp_path):
    skipped = shutil.ignore_patterns("__pycache__", "course", "reproduction")
    package = shutil.copytree(
        Path(rl.__file__).parent, tmp_path / "rlrobot_edu", ignore=skipped
    )
    shutil.copytree(shipped("tasks"), tmp_path / "tasks")
    path, seen = package / "learning" / "algorithms" / "q_learning.py", []
    text = path.read_text(encoding="utf-8")
    for rule in ("alpha * delta", "0.25 * delta", "0.125 * delta"):
        path.write_text(
            text.replace("+= alpha * delta", f"+= {rule}"), encoding="utf-8"
        )
        q = [
            in_another_process(
                LEARN, tmp_path, NUMBA_DISABLE_JIT=plain, PYTHONDONTWRITEBYTECODE="1"
            )
            for plain in "01"
        ]
        assert q[0] == q[1]
        seen.append(q[0])
    assert len({*seen}) == 3


HELPED = """
K = 0.5
{}
def g(x):
    return K * x
{}
def f(m, s, a, r, s_next, a_next, terminated):
    m.q[s, a] += {}
    return 0.0
"""


@pytest.mark.long
@pytest.mark.parametrize("world", ["wander_simple", "model"])
@pytest.mark.parametrize("decorators", [("", "", "K"), ("", "@compiled", "K"), ("@compiled", "", "g(1.0)"),
                                        ("@compiled", "@compiled", "g(1.0)")])  # fmt: skip
def test_what_a_method_refers_to_is_as_it_is_when_learning_begins(
    decorators, world, wander_model
):
    world = wander_model if world == "model" else world
    method = method_of(HELPED.format(*decorators))
    space = getattr(
        method.algorithm.update, "py_func", method.algorithm.update
    ).__globals__
    old = rl.Agent(world, method, seed=0)
    for k in (0.5, 0.25, 0.5, 0.125):
        space["K"] = k
        new, before = rl.Agent(world, method, seed=0), old.q.sum()
        for agent in (old, new):
            rl.learn(agent, rl.make_env(world, seed=0), 8, progress=False)
        assert (new.q.sum(), old.q.sum() - before) == (8 * k, 8 * k)
