"""Expressions of a plain function, in the text that is the same for Python, numba and JavaScript."""

import ast
from collections.abc import Callable, Mapping, Sequence
from types import FunctionType
from typing import NoReturn, Protocol

from rlrobot_edu.task.plain.names import (
    NUMBER,
    READINGS,
    Kind,
    is_local,
    meaning,
    plain_number,
    why_no_number,
    word_of,
)
from rlrobot_edu.task.plain.source import NotPlainError, place

ZERO = ast.Constant(0.0)
ONE = ast.Constant(1.0)
COMPARISONS = ast.Lt | ast.LtE | ast.Gt | ast.GtE | ast.Eq | ast.NotEq
DEEPEST = 3  # an `or` as a number writes its first part twice, an `or` in that part four times
INSTEAD = {
    ast.Pow: "write x * x, or sqrt(x)",
    ast.FloorDiv: "compare with limits, or use round",
    ast.Mod: "compare with limits, or use round",
    ast.ListComp: "write out each part",
    ast.GeneratorExp: "write out each part",
    ast.Subscript: "give each number a name, and choose by if",
}
INSTEAD_OF_CALL = {
    "hypot": "use length of rlrobot_edu.task.rewards",
    "float": "leave it out: all numbers are floats",
    "int": "use round",
    "bool": "compare with a number",
    "any": "write a or b",
    "all": "write a and b",
    "sum": "write a + b",
}


class Calls(Protocol):
    """What writes the helpers that a function calls."""

    readings: frozenset[str] | None

    def call(
        self,
        function: FunctionType,
        given: Sequence[ast.expr],
        by_name: Mapping[str, ast.expr],
        argument: Callable[[ast.expr], tuple[Kind, ast.expr]],
        refuse: Callable[[str], NoReturn],
    ) -> ast.expr:
        """The call of a helper, with arguments by place and by name; see `_Module` in writer.py."""


class Expressions:
    """Turns the expressions of one function into plain ones.

    function: the function with these expressions
    kinds: the kind of each of its arguments
    assigned: names of arguments and variables that surely have a value now
    """

    def __init__(
        self, function: FunctionType, kinds: Mapping[str, Kind], calls: Calls
    ) -> None:
        self.function = function
        self.kinds = kinds
        self.calls = calls
        self.assigned = set(kinds)
        self._depth = 0

    def refuse(self, node: ast.AST, what: str = "", instead: str = "") -> NoReturn:
        """Raise NotPlainError that names the line of a node."""
        if not what:
            first_line = ast.unparse(node).splitlines()[0]
            what = f"“{first_line:.60}”"
        advice = f"; {instead}" if instead else ""
        raise NotPlainError(
            f"{place(self.function, node)}: {what} is not plain{advice}"
        )

    def number(self, node: ast.expr) -> ast.expr:
        """An expression as a number."""
        match node:
            case ast.Constant(value):
                return self._literal(value, node)
            case ast.Name(name) if is_local(self.function.__code__, name):
                return self._variable(name, node)
            case ast.Name() | ast.Attribute():
                return self._literal(meaning(self.function, node), node)
            case ast.Subscript(ast.Name(name), key) if self.kind_of(name) == READINGS:
                return self._reading(name, key, node)
            case ast.UnaryOp(ast.UAdd(), x):
                return self.number(x)
            case ast.UnaryOp(ast.USub(), x):
                return ast.UnaryOp(ast.USub(), self.number(x))
            case ast.BinOp(left, operator, right):
                a = self.number(left)
                b = self.number(right)
                return self.operation(a, operator, b, node)
            case ast.IfExp(test, then, otherwise):
                condition = self.condition(test)
                a = self.number(then)
                b = self.number(otherwise)
                return ast.IfExp(condition, a, b)
            case ast.Compare() | ast.UnaryOp(ast.Not()):
                return ast.IfExp(self.condition(node), ONE, ZERO)
            case ast.BoolOp(operator, [*values]):
                return self._chosen(operator, values, node)
            case ast.Call():
                return self._call(node)
        self.refuse(node, instead=INSTEAD.get(type(node), ""))

    def condition(self, node: ast.expr) -> ast.expr:
        """An expression as what an `if` asks."""
        match node:
            case ast.BoolOp(operator, values):
                return ast.BoolOp(operator, [self.condition(value) for value in values])
            case ast.UnaryOp(ast.Not(), x):
                return ast.UnaryOp(ast.Not(), self.condition(x))
            case ast.Compare(left, operators, others):
                if not all(isinstance(by, COMPARISONS) for by in operators):
                    self.refuse(node)
                first, *rest = [self.number(each) for each in (left, *others)]
                return ast.Compare(first, operators, rest)
        return is_true(self.number(node))

    def operation(
        self, a: ast.expr, operator: ast.operator, b: ast.expr, node: ast.AST
    ) -> ast.expr:
        """Two plain numbers, added, subtracted, multiplied or divided; node: what it is in the function."""
        if isinstance(operator, ast.Add | ast.Sub | ast.Mult):
            return called("exact", ast.BinOp(a, operator, b))
        if isinstance(operator, ast.Div):
            return called("divided", a, b)
        self.refuse(node, instead=INSTEAD.get(type(operator), ""))

    def kind_of(self, name: str) -> Kind | None:
        """What an argument is; None for a name that is no argument."""
        return self.kinds.get(name)

    def argument(self, node: ast.expr) -> tuple[Kind, ast.expr]:
        """The kind of an argument of a helper, and the plain expression for it."""
        if isinstance(node, ast.Name) and self.kind_of(node.id) == READINGS:
            return READINGS, ast.Name(variable(node.id))
        text = self._text(node)
        if text is not None:
            return Kind("text", text), node
        return NUMBER, self.number(node)

    def _literal(self, value: object, node: ast.expr) -> ast.expr:
        number = plain_number(value)
        if number is None:
            self.refuse(node, instead=why_no_number(value))
        return literal(number)

    def _variable(self, name: str, node: ast.AST) -> ast.expr:
        if name not in self.assigned:
            self.refuse(node, instead="it may have no value here")
        if self.kind_of(name) not in (None, NUMBER):
            self.refuse(node, instead="a number is needed here")
        return ast.Name(variable(name))

    def _text(self, node: ast.expr) -> str | None:
        """The text that an expression stands for; None if it stands for something else."""
        if isinstance(node, ast.Constant):
            value = node.value
        elif isinstance(node, ast.Name) and is_local(self.function.__code__, node.id):
            kind = self.kind_of(node.id)
            value = kind.text if kind and kind.what == "text" else None
        else:
            value = meaning(self.function, node)
        return value if type(value) is str else None

    def _reading(self, readings: str, key: ast.expr, node: ast.expr) -> ast.expr:
        name = self._text(key)
        if name is None:
            self.refuse(node, instead="write the reading's name")
        if self.calls.readings is not None and name not in self.calls.readings:
            self.refuse(node, instead="the robot has no such reading")
        return ast.Subscript(ast.Name(variable(readings)), ast.Constant(name))

    def _chosen(
        self, operator: ast.boolop, values: list[ast.expr], node: ast.expr
    ) -> ast.expr:
        """``a or b`` as a number is the first one that is not 0; ``a and b`` the first one that is 0; else the last."""
        if len(values) == 1:
            return self.number(values[0])
        if self._depth == DEEPEST:
            self.refuse(node, instead="give a part of it a name")
        self._depth += 1
        first = self.number(values[0])
        self._depth -= 1
        rest = self._chosen(operator, values[1:], node)
        if isinstance(operator, ast.Or):
            return ast.IfExp(is_true(first), first, rest)
        return ast.IfExp(is_true(first), rest, first)

    def _call(self, node: ast.Call) -> ast.expr:
        function = meaning(self.function, node.func)
        by_name = {keyword.arg or "**": keyword.value for keyword in node.keywords}

        def refuse(what: str) -> NoReturn:
            self.refuse(node, what)

        if isinstance(function, FunctionType):
            return self.calls.call(function, node.args, by_name, self.argument, refuse)
        word = word_of(function)
        if word is None:
            name = ast.unparse(node.func).rpartition(".")[2]
            self.refuse(node, instead=INSTEAD_OF_CALL.get(name, ""))
        numbers = [self.number(argument) for argument in node.args]
        is_many = word in ("smaller", "larger")
        fits = len(numbers) >= 2 if is_many else len(numbers) == 1
        if by_name or not fits:
            self.refuse(node, instead="give it numbers, and as many as the table says")
        if not is_many:
            return called(word, numbers[0])
        result = numbers[0]
        for number in numbers[1:]:
            result = called(word, result, number)
        return result


def literal(number: float) -> ast.expr:
    """A number as the text has it: of a negative one, the sign is an operator."""
    if number < 0:
        return ast.UnaryOp(ast.USub(), ast.Constant(-number))
    return ast.Constant(number)


def variable(name: str) -> str:
    """A name of a function in the plain text: one that means nothing to JavaScript, nor in that text."""
    return f"{name}_"


def called(name: str, *arguments: ast.expr) -> ast.expr:
    """The call of a function of this name."""
    return ast.Call(ast.Name(name), list(arguments), [])


def is_true(number: ast.expr) -> ast.expr:
    """Whether a number is not 0; true for NaN, too."""
    return ast.Compare(number, [ast.NotEq()], [ZERO])
