"""In a run each quantity counts: what is stored or passed on may not be its sign, rank, rounding, or the one before."""

import ast
import bisect
import copy
import inspect
import textwrap
from types import FunctionType

import numpy as np
import pytest
from test_checks import exercises

from rlrobot_grading.answers.values import same
from rlrobot_grading.exercises.exercise import Exercise

RUNS = (
    ("assignment_1", "returns"),
    ("assignment_1", "replay"),
    ("assignment_1", "train"),
    ("assignment_2", "double_learn"),
    ("assignment_3", "trace_after"),
    ("assignment_3", "td_episode"),
    ("assignment_3", "true_online_episode"),
    ("assignment_4", "drive"),
    ("assignment_5", "value_of"),
    ("lesson_03", "learn"),
    ("lesson_06", "sarsa_learn"),
    ("lesson_10", "learn"),
    ("lesson_10", "learn_and_evade"),
    ("lesson_17", "dyna"),
    ("lesson_20", "learn_from"),
)


LENGTHS = ("len", "np.zeros_like")  # of these arguments only the length counts


class Sign:
    def of(self, x):
        return np.sign(x)


class Rounding:
    def of(self, x):
        return np.round(x)


class Hundredths:
    def of(self, x):
        return np.round(x, 2)


class Rank:
    """How many smaller ones there were before."""

    def __init__(self):
        self.seen = []

    def of(self, x):
        if np.ndim(x):
            return np.argsort(np.argsort(x, axis=None)).reshape(np.shape(x))
        rank = bisect.bisect_left(self.seen, x)
        if x not in self.seen:
            self.seen.insert(rank, x)
        return rank


class Before:
    """The one of the step before."""

    def __init__(self):
        self.last = None

    def of(self, x):
        before = x if self.last is None else self.last
        self.last = copy.deepcopy(x)
        return before


class Other:
    """Something else than a quantity, put in its place in the code of a run."""

    def __init__(self, kind):
        self.kind = kind
        self.changes = False
        self.start()

    def start(self):
        """Begin another run."""
        self.now = self.kind()

    def __call__(self, x):
        is_number = np.asarray(x).dtype.kind in "biuf"
        if isinstance(x, bool | np.bool_) and self.kind is not Before:
            return x
        if not is_number and self.kind is not Before:
            return x
        other = self.now.of(x)
        if isinstance(x, int | np.integer) and not isinstance(x, bool):
            other = int(other)
        self.changes |= not same(other, x)
        return other


def quantities(tree: ast.AST) -> list[ast.expr]:
    """The places of a run's code at which a variable is passed on, or stored: in a call, a list or a tuple."""
    found = []
    for node in ast.walk(tree):
        parts: list[ast.expr] = []
        if isinstance(node, ast.Call) and ast.unparse(node.func) not in LENGTHS:
            parts = [*node.args]
        elif isinstance(node, ast.List | ast.Tuple) and isinstance(node.ctx, ast.Load):
            parts = [*node.elts]
        elif isinstance(node, ast.Assign | ast.AugAssign | ast.Return):
            parts = [*([node.value] if node.value is not None else [])]
        found += [
            part
            for part in parts
            if not isinstance(part, ast.Constant | ast.Starred | ast.Tuple | ast.List)
        ]
    subscripts = {
        id(part)
        for node in ast.walk(tree)
        if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Tuple)
        for part in node.slice.elts
    }
    return [part for part in found if id(part) not in subscripts]


def with_other(right: FunctionType, place: int, other: Other):
    """`right` with `other` at one of its places, and what stands there."""
    tree = ast.parse(textwrap.dedent(inspect.getsource(right)))
    part = quantities(tree)[place]
    said = f"{ast.unparse(part)} (line {part.lineno})"

    class Put(ast.NodeTransformer):
        def visit(self, node):
            if node is not part:
                return super().generic_visit(node)
            call = ast.Call(ast.Name("OTHER", ast.Load()), [node], [])
            return ast.copy_location(call, node)

    tree = ast.fix_missing_locations(Put().visit(tree))
    names = {**right.__globals__, "OTHER": other}
    exec(compile(tree, "<run>", "exec"), names)
    return names[right.__name__], said


def survivors(exercise: Exercise, kind: type) -> set[str]:
    """The quantities of which it makes no difference whether they are of this kind."""
    tree = ast.parse(textwrap.dedent(inspect.getsource(exercise.right)))
    alive = set()
    for place in range(len(quantities(tree))):
        other = Other(kind)
        answer, said = with_other(exercise.right, place, other)
        is_right = True
        for right, case in zip(exercise.expected, exercise.cases, strict=True):
            other.start()
            is_right = right.equals(exercise.outcome(answer, case))
            if not is_right:
                break
        if is_right and other.changes:
            alive.add(said)
    return alive


@pytest.mark.long
@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("kind", [Sign, Rank, Rounding, Hundredths, Before])
@pytest.mark.parametrize(("lesson", "name"), RUNS)
def test_in_a_run_no_quantity_may_be_another(lesson, name, kind):
    assert survivors(exercises(lesson)[name], kind) == set()
