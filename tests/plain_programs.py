"""Plain functions and readings drawn at random, and what becomes of them as Python, numba and JavaScript.

    python tests/plain_programs.py --functions 100000 --compiled 300

draws so many programs, each a reward and a goal with helpers, and stops at the first whose three ways differ.
"""

import argparse
import json
import linecache
import math
import random
import re
import subprocess
import sys
import time
from itertools import count

import numpy as np

from rlrobot_edu.jit.dispatcher import numba
from rlrobot_edu.robots.engines.kinematic.compiled_task import judge_of
from rlrobot_edu.task.plain import functions_of, plain_text
from rlrobot_edu.task.robot_cards import ROBOTS
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task
from rlrobot_edu.widgets.javascript.program import program

NAMES = ("x", "y", "theta", "laser front")
AROUND = """
import math
from math import sqrt, sqrt as wurzel
LIMIT, COUNT, IS_ON, NEGATIVE, LARGE, FAR, NAME = 0.3, 7, True, -2, 2**52 + 1, math.inf, "x"
def near(readings, limit=0.3, *, name="laser front"):
    return readings[name] < limit
def way(before, after, name):
    return after[name] - before[name]
def length(x, y):
    return sqrt(x * x + y * y)
def sign(x):
    if x > 0:
        return 1
    elif x < 0:
        return -1
    return 0
def above(limit, name):
    return lambda readings: readings[name] > limit
high = above(1, "y")
"""
# also words of JavaScript, and names of the text that is written
VARIABLES = ("a", "var", "function", "exact", "NaN", "reward_0", "π")
LITERALS = (
    *("0", "1", "2", "3", "7", "10", "100", "0.0", "0.1", "0.5", "1.5", "2.5", "1e-9"),
    *(
        "True",
        "False",
        "LIMIT",
        "COUNT",
        "IS_ON",
        "NEGATIVE",
        "LARGE",
        "FAR",
        "math.pi",
    ),
    *("9007199254740991", "4503599627370497", "1e300"),
)
NUMBERS = (
    *(
        "(A + B)",
        "(A - B)",
        "(A * B)",
        "(A / B)",
        "(-A)",
        "(+A)",
        "abs(A)",
        "min(A, B)",
    ),
    *("max(A, B, C)", "round(A)", "round(A / 0.3)", "sqrt(abs(A))", "math.sqrt(A)"),
    *("wurzel(A)", "(A if P else B)", "(A or B)", "(A and B)", "(P)", "sign(A)"),
    "length(A, y=B)",
)
OF_HELPER = ("helper(before, after, A)", "helper(after, before, q=A, p=B)")
OF_WAY = ("way(before, after, NAME)", 'way(before, after, name="y")')
CONDITIONS = (
    *(
        "A < B",
        "A <= B",
        "A > B",
        "A >= B",
        "A == B",
        "A != B",
        "A < B <= C",
        "(not P)",
    ),
    *("(P and Q)", "(P or Q)", "A", "near(R)", "near(R, A, name='y')", "high(R)"),
)
EDGES = (
    *(0.0, -0.0, 0.5, -0.5, 1.5, 2.5, 0.3, 1.0, -1.0, 0.49999999999999994, 5e-324),
    *(-5e-324, 1e-200, 1e8, 4503599627370496.5, 9007199254740991.0, 9007199254740992.0),
    *(-9007199254740993.0, 1e16, 1e300, -1.7976931348623157e308, math.inf, -math.inf),
    math.nan,
)


class Drawn:
    """Draws programs; the same for the same seed."""

    def __init__(self, seed):
        self.rng = random.Random(seed)
        self.known = []

    def program(self):
        """The text of a module with a reward and a goal."""
        helper = self._function("helper", ["before", "after", "p", "q=2"], ["p", "q"])
        reward = self._function("reward", ["before", "after"], [], has_helper=True)
        self.known, self.has_helper = [], False
        self.readings = ["readings"]
        goal = f"goal = lambda readings: {self.condition(3)}\n"
        return f"{helper}{reward}{goal}"

    def _function(self, name, arguments, known, has_helper=False):
        self.readings = ["before", "after"]
        self.known, self.has_helper = list(known), has_helper
        lines = self.block(self.rng.randint(0, 4), 2)
        lines.append(f"return {self.number(3)}")
        body = "\n".join(f"    {line}" for line in lines)
        return f"def {name}({', '.join(arguments)}):\n{body}\n"

    def block(self, length, depth):
        """Lines of statements that may return early."""
        return [line for _ in range(length) for line in self.statement(depth)]

    def statement(self, depth):
        """The lines of a statement."""
        kind = self.rng.choice(["=", "=", "=", ":", "+=", ",", "if", "if"])
        if kind == "if" and depth:
            return self._choice(depth)
        if kind == "+=" and self.known:
            by = self.rng.choice(["+", "-", "*", "/"])
            return [f"{self.rng.choice(self.known)} {by}= {self.number(2)}"]
        if kind == ",":
            one, other = self.rng.sample(VARIABLES, 2)
            line = f"{one}, {other} = {self.number(2)}, {self.number(2)}"
            self.known += [one, other]
            return [line]
        name = self.rng.choice(VARIABLES)
        line = f"{name}{': float' if kind == ':' else ''} = {self.number(3)}"
        self.known.append(name)
        return [line]

    def _choice(self, depth):
        """The lines of an `if`; afterwards, known is what each way that goes on has made known."""
        lines, before, after = [], list(self.known), None
        for word in ("if", "elif", "else")[: self.rng.randint(1, 3)]:
            test = "" if word == "else" else f" {self.condition(2)}"
            inner = self.block(self.rng.randint(1, 2), depth - 1)
            ends = self.rng.random() < 0.3
            if ends:
                inner.append(f"return {self.number(2)}")
            lines += [f"{word}{test}:", *(f"    {line}" for line in inner)]
            if not ends:
                known = set(self.known)
                after = known if after is None else after & known
            self.known = list(before)
        if word != "else":
            after = set(before)  # it may have been none of these
        self.known = sorted(before if after is None else after)
        return lines

    def number(self, depth):
        """An expression for a number."""
        if not depth or self.rng.random() < 0.15:
            return self._leaf()
        forms = list(NUMBERS)
        if self.has_helper:
            forms += OF_HELPER
        if len(self.readings) == 2:
            forms += OF_WAY
        return self._filled(self.rng.choice(forms), depth - 1)

    def condition(self, depth):
        """An expression for a truth value."""
        forms = CONDITIONS if depth else ["A < B"]
        return self._filled(self.rng.choice(forms), max(depth - 1, 0))

    def _filled(self, form, depth):
        """A form with expressions for A, B and C, conditions for P and Q, and readings for R."""
        words = []
        for word in re.split(r"\b([A-CP-R])\b", form):
            if word in ("A", "B", "C"):
                word = self.number(depth)
            elif word in ("P", "Q"):
                word = self.condition(depth)
            elif word == "R":
                word = self.rng.choice(self.readings)
            words.append(word)
        return "".join(words)

    def _leaf(self):
        draw = self.rng
        kind = draw.random()
        if kind < 0.5:
            name = draw.choice([*map(repr, NAMES), "NAME"])
            return f"{draw.choice(self.readings)}[{name}]"
        if kind < 0.7 and self.known:
            return draw.choice(self.known)
        return draw.choice(LITERALS)

    def readings_pair(self):
        """Readings before and after a step: near 0, or from the whole range with its edges."""
        share = self.rng.choice([0.0, 0.1, 0.5])
        return [
            {name: self.reading(share) for name in NAMES} for _ in ("before", "after")
        ]

    def reading(self, share):
        """One number, by this share from the whole range and its edges."""
        if self.rng.random() < share:
            if self.rng.random() < 0.5:
                return self.rng.choice(EDGES)
            return math.ldexp(self.rng.uniform(-1, 1), self.rng.randint(-1073, 1024))
        return round(self.rng.uniform(-3, 3), self.rng.choice([1, 2, 17]))


numbers = count()


def module_of(text, around):
    """What a text defines amid these names, with its lines where Python looks for them."""
    file = f"<drawn program {next(numbers)}>"
    linecache.cache[file] = len(text), None, text.splitlines(keepends=True), file
    space = {"__name__": "drawn_program", **around}
    exec(compile(text, file, "exec", dont_inherit=True), space)
    return space


def answer(function, *readings):
    """What a reward or goal says, as text that tells all bits; GIVEN_BACK where it raises."""
    try:
        return repr(float(function(*readings)) + 0.0)
    except (ArithmeticError, ValueError):
        return GIVEN_BACK


SURROUNDINGS = module_of(AROUND, {})
GIVEN_BACK = "given back"
NODE = """
require("readline").createInterface({ input: process.stdin }).on("line", (line) => {
  const job = JSON.parse(line), kernels = (0, eval)(job.program);
  const read = (given) => Object.fromEntries(Object.entries(given).map(([name, x]) => [name, Number(x)]));
  const say = (name, given) => {
    let said;
    try { said = Number(kernels[name](...given.map(read))); } catch (error) {
      if (error.constructor !== Error) throw error;
      return "given back";
    }
    return Object.is(said, -0) ? "-0.0" : String(said);
  };
  console.log(JSON.stringify(job.asked.map(([name, given]) => say(name, given))));
});
"""


class Node:
    """JavaScript's answers."""

    def __init__(self):
        self.process = subprocess.Popen(
            ["node", "-e", NODE],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )

    def answers(self, functions, asked):
        """What functions of a plain text say; asked: names and readings."""
        told = [
            (name, [{key: in_javascript(x) for key, x in one.items()} for one in given])
            for name, given in asked
        ]
        job = {"program": program(functions), "asked": told}
        self.process.stdin.write(json.dumps(job) + "\n")
        self.process.stdin.flush()
        answers = json.loads(self.process.stdout.readline())
        return [a if a == GIVEN_BACK else repr(float(a)) for a in answers]

    def close(self):
        self.process.stdin.close()
        self.process.wait(60)
        self.process.stdout.close()


def in_javascript(x):
    return repr(x).replace("inf", "Infinity").replace("nan", "NaN")


def task_of(reward, goal):
    """A task with these functions, whose robot does not matter."""
    like = load_task("wander_1k")
    return Task(
        like.robot, like.scene, like.inputs, like.outputs, reward, [1], goal=goal
    )


class Judged:
    """Numba's answers. names: of the readings; None for those of the task's robot."""

    def __init__(self, task, names=None):
        names = tuple(names or ROBOTS[task.robot].sensors)
        self.judge = judge_of(task, names)
        self.kind = np.dtype([(name, float) for name in names])
        self.ask = numba.njit(lambda judge, pair: judge(pair[0], pair[1]))

    def answer(self, before, after):
        """Reward and goal as texts; the reward is NaN where one of them was given back."""
        pair = np.array([tuple(before.values()), tuple(after.values())], self.kind)
        reward, is_there = self.ask(self.judge, pair)
        return repr(reward), repr(float(is_there))


def compare(text, pairs, node=None, is_compiled=False):
    """The answers of a program's ways must be equal; returns how many were given back, and how many there were."""
    space = module_of(text, SURROUNDINGS)
    written = functions_of(
        plain_text({"reward": space["reward"]}, {"goal": space["goal"]}, NAMES)
    )
    functions = {name: written[name] for name in ("reward", "goal")}
    own_functions = {
        "reward": space["reward"],
        "goal": lambda readings: bool(space["goal"](readings)),
    }
    asked = [("reward", pair) for pair in pairs]
    asked += [("goal", pair[1:]) for pair in pairs]
    plain = [answer(functions[name], *given) for name, given in asked]
    if node is not None:
        for one, two, (name, given) in zip(
            plain, node.answers(functions, asked), asked, strict=True
        ):
            assert one == two, f"{text}\n{name} {given}: {one}, in JavaScript {two}"
    needless = 0
    for one, (name, given) in zip(plain, asked, strict=True):
        own = answer(own_functions[name], *given)
        if one != GIVEN_BACK:
            assert own == one, f"{text}\n{name} {given}: {own}, as a plain text {one}"
        elif own != GIVEN_BACK:
            needless += 1
    if is_compiled:
        judged = Judged(task_of(space["reward"], space["goal"]), NAMES)
        for pair, r, is_there in zip(
            pairs, plain[: len(pairs)], plain[len(pairs) :], strict=True
        ):
            wanted = ("nan", "0.0") if GIVEN_BACK in (r, is_there) else (r, is_there)
            found = judged.answer(*pair)
            assert found == wanted, f"{text}\n{pair}: {wanted}, compiled {found}"
    return plain.count(GIVEN_BACK), needless, len(plain)


def main():
    """Compare many programs."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--functions", type=int, default=1000)
    parser.add_argument("--compiled", type=int, default=0, help="so many by numba, too")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--readings", type=int, default=6, help="pairs a program")
    given = parser.parse_args()
    drawn, node, begun = Drawn(given.seed), Node(), time.perf_counter()
    totals = np.zeros(3, int)
    for i in range(given.functions):
        pairs = [drawn.readings_pair() for _ in range(given.readings)]
        totals += compare(drawn.program(), pairs, node, i < given.compiled)
        if (i + 1) % 1000 == 0:
            linecache.clearcache()
            print(i + 1, f"{time.perf_counter() - begun:.0f} s", *totals, flush=True)
    node.close()
    back, needless, answers = totals
    print(
        f"{given.functions} programs, {answers} answers, all the same; {back} given back "
        f"to Python, of which {needless} had an answer there"
    )


if __name__ == "__main__":
    sys.exit(main())
