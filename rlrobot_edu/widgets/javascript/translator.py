"""One kernel as JavaScript.

A kernel is what numba compiles here: numbers, arrays of one or two dimensions, records, loops. An array of two
dimensions is an array of rows in JavaScript, so ``q[s, a]`` becomes ``q[s][a]``. The library pscript (0.8.1) takes
that for a slice, and makes each ``+`` and ``*`` a call.

JavaScript has no arithmetic of arrays: ``q[s] + 1`` would be a text there, and ``visits[s].size`` undefined. What a
kernel may do with a whole array is to take its largest or smallest entry, to set all its entries to one number, and to
hand it to another kernel. All else is refused.

A task's reward and goal are translated as plain functions, see `rlrobot_edu.task.plain`.
"""

import ast
import builtins
import inspect
import textwrap
from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any, NoReturn

from rlrobot_edu.widgets.javascript.arrays import (
    is_array,
    is_negative,
    is_row,
    names_of_arrays,
    names_of_records,
    names_stored,
)
from rlrobot_edu.widgets.javascript.vocabulary import (
    NOT_TRANSLATED,
    OF_AN_ARRAY,
    OF_MATH,
    OPERATORS,
    WORDS,
    literal,
)


class Translator:
    """The translation of one function.

    function: the kernel, compiled or not
    name_of: returns the JavaScript for a function, a number or None that the kernel uses
    arithmetic: names of JavaScript functions that are called in place of some operators, for numbers of another kind
    """

    def __init__(
        self,
        function: Callable[..., Any],
        name_of: Callable[[Any], str | None],
        arithmetic: Mapping[type[ast.AST], str] | None = None,
    ) -> None:
        self.arithmetic = arithmetic or {}
        self.function = getattr(function, "py_func", function)
        lines, self.first = inspect.getsourcelines(self.function)
        definition = ast.parse(textwrap.dedent("".join(lines))).body[0]
        assert isinstance(definition, ast.FunctionDef)
        self.definition = definition
        self.name_of = name_of
        nodes = list(ast.walk(definition))
        self.parameters = [argument.arg for argument in definition.args.args]
        stored = names_stored(nodes)
        self.variables = sorted(stored - set(self.parameters))
        # closurevars takes the names of fields, too; some may be names of parameters or variables
        names = inspect.getclosurevars(self.function)
        self.around = {**names.builtins, **names.globals, **names.nonlocals}
        for name in stored.union(self.parameters):
            self.around.pop(name, None)
        self.records = names_of_records(nodes)
        self.arrays = names_of_arrays(nodes)

    def translate(self, name: str) -> str:
        """The text of the function, under this name. Raises ValueError, with file and line, if there is none."""
        body = self._block(self.definition.body)
        declared = f"let {', '.join(self.variables)};\n" if self.variables else ""
        return f"function {name}({', '.join(self.parameters)}) {{\n{declared}{body}\n}}"

    def _refuse(self, node: ast.AST, what: str) -> NoReturn:
        line = self.first + getattr(node, "lineno", 1) - 1
        file = Path(inspect.getsourcefile(self.function) or "").name
        raise ValueError(
            f"{file}:{line}: {what} has no translation to JavaScript, so no page can "
            "run it; write it with numbers, entries of arrays, if, while and for over a range"
        )

    def _number(self, node: ast.expr) -> str:
        """The value of what must be a number in JavaScript."""
        if is_array(node, self.arrays):
            self._refuse(node, f"“{ast.unparse(node)}”, a whole array as a number,")
        return self._value(node)

    def _given_to(self, target: ast.expr, value: ast.expr) -> str:
        """A value to be assigned: entries of arrays take numbers."""
        if isinstance(target, ast.Subscript):
            return self._number(value)
        return self._value(value)

    def _values(self, nodes: Iterable[ast.expr]) -> str:
        """Several values, with commas."""
        return ", ".join(self._value(node) for node in nodes)

    def _block(self, statements: Sequence[ast.stmt]) -> str:
        lines = [self._statement(statement) for statement in statements]
        return "\n".join(line for line in lines if line)

    def _statement(self, node: ast.stmt) -> str:
        match node:
            case ast.Expr(ast.Constant(str())) | ast.Pass():
                return ""
            case ast.Expr(value):
                return f"{self._value(value)};"
            case ast.Assign([ast.Tuple(to)], ast.Tuple(of)) if len(to) == len(of):
                return self._assign_tuple(to, of)
            case ast.Assign(targets, value):
                if len(targets) > 1:
                    return self._assign_all(targets, value)
                return self._assign(targets[0], self._given_to(targets[0], value))
            case ast.AugAssign(target, operator, value):
                place = self._number(target)
                change = self._number(value)
                if type(operator) in (ast.FloorDiv, ast.Mod, *self.arithmetic):
                    result = self._operation(place, operator, change, node)
                    return f"{place} = {result};"
                return f"{place} {self._operator(operator, node)}= {change};"
            case ast.If(
                ast.Compare(ast.Name(x), [ast.Is()], [ast.Constant(None)]), body, rest
            ) if x in self.around:
                # This was decided when the kernel was made.
                return self._block(body if self.around[x] is None else rest)
            case ast.If(test, body, rest):
                otherwise = f" else {{\n{self._block(rest)}\n}}" if rest else ""
                text = f"if ({self._number(test)}) {{\n{self._block(body)}\n}}"
                return text + otherwise
            case ast.While(test, body, []):
                return f"while ({self._number(test)}) {{\n{self._block(body)}\n}}"
            case ast.For(
                ast.Name(i), ast.Call(ast.Name("range"), [*bounds], []), body, []
            ) if 1 <= len(bounds) <= 2:
                low = "0" if len(bounds) == 1 else self._value(bounds[0])
                high = self._value(bounds[-1])
                self._stays_inside(i, node)
                # The end is computed once, as that of a range.
                head = f"for (let $end = {high}, $at = {low}; $at < $end; $at++)"
                return f"{head} {{\n{i} = $at;\n{self._block(body)}\n}}"
            case ast.Return(value):
                return f"return {self._value(value)};" if value else "return;"
            case ast.Raise(ast.Call(_, [ast.Constant(str() as why)])):
                return f"throw new Error({literal(why)});"
            case ast.Break() | ast.Continue():
                return f"{type(node).__name__.lower()};"
        self._refuse(node, f"“{ast.unparse(node).splitlines()[0]}”")

    def _stays_inside(self, name: str, loop: ast.For) -> None:
        """Refuse a loop that changes its variable. After the loop it has its last value, in both languages."""
        for statement in loop.body:
            for node in ast.walk(statement):
                if name in names_stored([node]):
                    self._refuse(node, f"a loop that changes its own {name}")

    def _assign(self, target: ast.expr, value: str) -> str:
        match target:
            case ast.Subscript(array, ast.Slice(None, None, None)):
                return f"{self._value(array)}.fill({value});"
            case ast.Subscript(array, index) if is_row(target):
                return f"{self._value(array)}[{self._value(index)}].fill({value});"
        return f"{self._value(target)} = {value};"

    def _assign_tuple(
        self, targets: Sequence[ast.expr], values: Sequence[ast.expr]
    ) -> str:
        """All values first, then all assignments: a browser would make an array for [a, b] = [x, y]."""
        held = []
        for i, (target, value) in enumerate(zip(targets, values, strict=True)):
            held.append(f"${i} = {self._given_to(target, value)}")
        given = [self._assign(target, f"${i}") for i, target in enumerate(targets)]
        lines = "\n".join(given)
        return f"{{\nconst {', '.join(held)};\n{lines}\n}}"

    def _assign_all(self, targets: Sequence[ast.expr], value: ast.expr) -> str:
        if not isinstance(value, ast.Constant):
            self._refuse(value, "a value other than a constant for several places")
        return "\n".join(self._assign(target, self._value(value)) for target in targets)

    def _operator(self, operator: ast.AST, node: ast.AST) -> str:
        if type(operator) not in OPERATORS:
            self._refuse(node, f"the operator of “{ast.unparse(node)}”")
        return OPERATORS[type(operator)]

    def _operation(
        self, left: str, operator: ast.operator, right: str, node: ast.AST
    ) -> str:
        if type(operator) in self.arithmetic:
            return f"{self.arithmetic[type(operator)]}({left}, {right})"
        if isinstance(operator, ast.FloorDiv):
            return f"Math.floor({left} / {right})"
        if isinstance(operator, ast.Mod):
            return f"remainder({left}, {right})"
        return f"({left} {self._operator(operator, node)} {right})"

    def _value(self, node: ast.expr) -> str:
        match node:
            case ast.Constant(None | int() | float() | str() as value):
                return literal(value)
            case ast.Name(name):
                return self._name(name, node)
            case ast.Tuple(parts):
                return f"[{self._values(parts)}]"
            case ast.BinOp(left, operator, right):
                a, b = self._number(left), self._number(right)
                return self._operation(a, operator, b, node)
            case ast.UnaryOp(ast.USub() as operator, operand) if (
                ast.USub in self.arithmetic
            ):
                return f"{self.arithmetic[ast.USub]}({self._number(operand)})"
            case ast.UnaryOp(operator, operand):
                return f"({self._operator(operator, node)}{self._number(operand)})"
            case ast.BoolOp(operator, values):
                word = f" {self._operator(operator, node)} "
                return f"({word.join(self._number(value) for value in values)})"
            case ast.Compare(left, operators, others):
                return self._comparison([left, *others], operators, node)
            case ast.IfExp(test, body, otherwise):
                condition = self._number(test)
                yes, no = self._value(body), self._value(otherwise)
                return f"({condition} ? {yes} : {no})"
            case ast.Attribute(ast.Name("math"), word) if word in OF_MATH:
                return OF_MATH[word]
            case ast.Attribute(record, field) if field not in NOT_TRANSLATED:
                return f"{self._value(record)}.{field}"
            case ast.Subscript(
                ast.Attribute(array, "shape"), ast.Constant(int(axis))
            ) if not self._is_record(array):
                return f"{self._value(array)}{'[0]' * axis}.length"
            case ast.Subscript(array, ast.Tuple([row, column])):
                rows = self._value(array)
                return f"{rows}[{self._value(row)}][{self._value(column)}]"
            case ast.Subscript(array, index) if not (
                isinstance(index, ast.Slice) or is_negative(index)
            ):
                return f"{self._value(array)}[{self._value(index)}]"
            case ast.Call(ast.Attribute(array, method), [], []) if (
                method in OF_AN_ARRAY
            ):
                return f"{method}_of({self._value(array)})"
            case ast.Call(ast.Attribute(_, method)) if method in NOT_TRANSLATED:
                self._refuse(node, f"“{ast.unparse(node)}”")
            case ast.Call(function, arguments, []):
                name = self._value(function)
                if name in {*WORDS.values(), *OF_MATH.values()}:
                    numbers = [self._number(argument) for argument in arguments]
                    return f"{name}({', '.join(numbers)})"
                return f"{name}({self._values(arguments)})"
        self._refuse(node, f"“{ast.unparse(node)}”")

    def _comparison(
        self, parts: Sequence[ast.expr], operators: Sequence[ast.cmpop], node: ast.expr
    ) -> str:
        """A comparison of two or more parts; JavaScript has only those of two."""
        if any(isinstance(part, ast.Tuple) for part in parts):
            self._refuse(node, f"“{ast.unparse(node)}”")
        texts = []
        for (left, right), operator in zip(pairwise(parts), operators, strict=True):
            a, b = self._number(left), self._number(right)
            texts.append(f"{a} {self._operator(operator, node)} {b}")
        return f"({' && '.join(texts)})"

    def _is_record(self, node: ast.expr) -> bool:
        return isinstance(node, ast.Name) and node.id in self.records

    def _name(self, name: str, node: ast.AST) -> str:
        if name not in self.around:
            return name
        if self.around[name] is getattr(builtins, name, None):
            text = WORDS.get(name)
        else:
            text = self.name_of(self.around[name])
        return text or self._refuse(node, name)
