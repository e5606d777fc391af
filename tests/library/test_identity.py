"""Two different programs never count as one, and one program counts as one in every process and every folder."""

import functools
import importlib
import os
import pickle
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import cloudpickle
import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.experiments.compare import facts_of
from rlrobot_edu.files import shipped
from rlrobot_edu.learning.fingerprint import code_of
from rlrobot_edu.learning.jit import IS_PLAIN, compiled
from rlrobot_edu.learning.methods import own_parts

# A program whose `f` is looked at, a text in it, and what stands there in another program
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


NAMES = """
import sys
from test_identity import PAIRS, code_of, made, rl
print({pair: made(program) for pair, (program, _, _) in PAIRS.items()})
"""


def in_another_process(script, *folders, seed="1", **environment):
    """What a script prints in a process with another order of sets, whose working folder is the first one."""
    paths = os.pathsep.join(map(str, folders))
    environment = {**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": paths, **environment}
    run = subprocess.run([sys.executable, "-c", script], env=environment, cwd=folders[0], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    return run.stdout.strip()


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
        for loaded in [loaded for loaded in sys.modules if loaded.partition(".")[0].startswith("own_")]:
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
        module("own_helper.py", f"OTHER = {other}\ndef g(x): return x\ndef unused(x): return {other}\n")
        names.add(made(f"import own_helper\nq = {other}\ndef f(m): return own_helper.g(m.q)"))  # q is no global here
    assert len(names) == 1
