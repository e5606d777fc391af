"""What a check hands to an answer in place of the real thing can be called in every way in which that can be called."""

import ast
import importlib
import inspect
import linecache
import textwrap
from pathlib import Path

import pytest

from rlrobot_course.worlds.callbacks import Chooser, QLearner, Ranked
from rlrobot_course.worlds.short_world import ShortWorld
from rlrobot_course.worlds.tapes import RobotWorld, TapeWorld
from rlrobot_grading.exercises.exercise import Exercise

COURSE = Path(importlib.import_module("rlrobot_course").__file__).parent
STEP = ("q", "s", "a", "r", "s_next", "terminated")
NAMES = {  # as the lessons say them
    "choose": ("q", "s"), "update": STEP, "pick": ("seen",), "toss": (), "step": ("a",), "reset": (), "random": (),
}  # fmt: skip
OTHERS = {
    ("sarsa_learn", "update"): ("q", "s", "a", "r", "s_next", "a_next", "terminated")
}


def with_doubles():
    """All exercises whose cases hold something that can be called, or whose methods can."""
    for room in sorted(COURSE.glob("*/exercises.py")):
        lesson = importlib.import_module(f"rlrobot_course.{room.parent.name}.exercises")
        for name, exercise in vars(lesson.check).items():
            if isinstance(exercise, Exercise):
                doubles = {
                    n: v
                    for n, v in exercise.cases[0].items()
                    if callable(v) or hasattr(v, "step")
                }
                if doubles:
                    yield pytest.param(
                        exercise, set(doubles), id=f"{room.parent.name} {name}"
                    )


class Named(ast.NodeTransformer):
    """Writes the arguments of calls of doubles by name, from the `first`-th on."""

    def __init__(self, exercise, doubles, first, action):
        self.exercise, self.doubles, self.first, self.action = (
            exercise,
            doubles,
            first,
            action,
        )
        self.n = 0

    def visit_Call(self, call):
        self.generic_visit(call)
        is_method = isinstance(call.func, ast.Attribute)
        who = getattr(call.func.value if is_method else call.func, "id", "")
        if who not in self.doubles or any(
            isinstance(one, ast.Starred) for one in call.args
        ):
            return call
        name = call.func.attr if is_method else who
        names = OTHERS.get((self.exercise, name), NAMES[name])
        names = tuple(
            self.action if one == "a" and name == "step" else one for one in names
        )
        assert len(names) == len(call.args)
        by_name = list(zip(names, call.args, strict=True))[self.first :][
            ::-1
        ]  # named ones may come in any order
        self.n += len(by_name)
        return ast.Call(
            call.func,
            call.args[: self.first],
            [ast.keyword(n, value) for n, value in by_name],
        )


@pytest.mark.parametrize(("exercise", "doubles"), list(with_doubles()))
def test_a_right_answer_may_name_what_it_hands_over(exercise, doubles):
    source = textwrap.dedent(inspect.getsource(exercise.right))
    for first, action in ((0, "a"), (0, "action"), (1, "a"), (5, "a")):
        change = Named(exercise.right.__name__, doubles, first, action)
        text = ast.unparse(ast.fix_missing_locations(change.visit(ast.parse(source))))
        file = f"<{exercise.right.__name__} by name from {first}, {action}>"
        linecache.cache[file] = len(text), None, text.splitlines(keepends=True), file
        made = dict(exercise.right.__globals__)
        exec(compile(text, file, "exec"), made)
        verdict = exercise.judge(made[exercise.right.__name__])
        assert verdict, f"{text}\n{verdict}"
        assert change.n or first, "nothing was named"


def test_the_worlds_of_the_course_take_the_action_by_both_names():
    for folder in [
        "",
        *(f"{path.parent.name}." for path in COURSE.glob("*/__init__.py")),
    ]:
        for path in sorted(Path(COURSE, folder.rstrip(".")).glob("*.py")):
            source = path.read_text(encoding="utf-8")
            if "def step(self, a: int)" in source:
                assert source.count(
                    "@with_action\n    def step(self, a: int)"
                ) == source.count("def step(self, a: int)")
    for world in (
        TapeWorld(),
        RobotWorld("wander_simple"),
        ShortWorld(RobotWorld("wander_simple").env),
    ):
        world.reset()
        assert (
            len(world.step(a=0)) == len(world.step(action=0)) == len(world.step(0)) == 4
        )
        for arguments, by_name in (
            ((), {}),
            ((0, 1), {}),
            ((0,), {"a": 1}),
            ((), {"b": 1}),
            ((), {"a": 1, "action": 1}),
        ):
            with pytest.raises(TypeError, match="takes an action and nothing else"):
                world.step(*arguments, **by_name)


def test_a_double_says_by_the_lessons_names_what_it_takes():
    q = [[0.0, 1.0]]
    for choose in (Ranked(0), Chooser(0)):
        for arguments, by_name in (
            ((q,), {}),
            ((0, q), {}),
            ((q, 0, 1), {}),
            ((q,), {"state": 0}),
            ((q, 0), {"s": 1}),
        ):
            with pytest.raises(
                TypeError, match=r"^choose takes \(q, s\), in this order$"
            ):
                choose(*arguments, **by_name)
    with pytest.raises(
        TypeError,
        match=r"^update takes \(q, s, a, r, s_next, terminated\), in this order$",
    ):
        QLearner(0.1, 0.9)(q, 0, 0, 1.0, 0)
