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
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, NoReturn

from rlrobot_edu.widgets.javascript.arrays import (
    is_array,
    is_negative,
    is_row,
    names_of_arrays,
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
    name_of: tells the JavaScript for what a name of its surroundings stands for: a function, a number or None
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
        self.definition, self.name_of = definition, name_of
        nodes = list(ast.walk(definition))
        self.parameters = [argument.arg for argument in definition.args.args]
        stored = {
            node.id
            for node in nodes
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
        }
        self.variables = sorted(stored - set(self.parameters))
        # a field's name may be that of something around, too
        names = inspect.getclosurevars(self.function)
        around = {**names.builtins, **names.globals, **names.nonlocals}
        self.around = {
            name: thing
            for name, thing in around.items()
            if name not in stored.union(self.parameters)
        }
        fields = [
            node
            for node in nodes
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name)
        ]
        self.records = {
            node.value.id for node in fields if node.attr not in {"shape", *OF_AN_ARRAY}
        }  # type: ignore[attr-defined]
        self.arrays = names_of_arrays(nodes)

    def translate(self, name: str) -> str:
        """The text of the function, under this name. Raises ValueError that tells file and line of what it refuses."""
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

    def _block(self, statements: Sequence[ast.stmt]) -> str:
        return "\n".join(filter(None, map(self._statement, statements)))

    def _statement(self, node: ast.stmt) -> str:
        match node:
            case ast.Expr(ast.Constant(str())) | ast.Pass():
                return ""
            case ast.Expr(value):
                return f"{self._value(value)};"
            case ast.Assign([ast.Tuple(targets)], ast.Tuple(values)) if len(
                targets
            ) == len(values):
                held = ", ".join(
                    f"${i} = {self._given_to(targets[i], value)}"
                    for i, value in enumerate(values)
                )
                given = "\n".join(
                    self._assign(target, f"${i}") for i, target in enumerate(targets)
                )
                return f"{{\nconst {held};\n{given}\n}}"  # a browser would make an array of [a, b] = [x, y]
            case ast.Assign(targets, value):
                if len(targets) > 1:
                    return self._assign_all(targets, value)
                return self._assign(targets[0], self._given_to(targets[0], value))
            case ast.AugAssign(target, operator, value):
                place, change = self._number(target), self._number(value)
                if type(operator) in (ast.FloorDiv, ast.Mod, *self.arithmetic):
                    return (
                        f"{place} = {self._operation(place, operator, change, node)};"
                    )
                return f"{place} {self._operator(operator, node)}= {change};"
            case ast.If(
                ast.Compare(ast.Name(x), [ast.Is()], [ast.Constant(None)]), body, rest
            ) if x in self.around:
                return self._block(
                    body if self.around[x] is None else rest
                )  # decided when the kernel was made
            case ast.If(test, body, rest):
                otherwise = f" else {{\n{self._block(rest)}\n}}" if rest else ""
                return (
                    f"if ({self._number(test)}) {{\n{self._block(body)}\n}}{otherwise}"
                )
            case ast.While(test, body, []):
                return f"while ({self._number(test)}) {{\n{self._block(body)}\n}}"
            case ast.For(
                ast.Name(i), ast.Call(ast.Name("range"), [*bounds], []), body, []
            ) if 1 <= len(bounds) <= 2:
                low, high = ["0", *map(self._value, bounds)][-2:]
                self._stays_inside(i, node)
                head = f"for (let $end = {high}, $at = {low}; $at < $end; $at++)"  # a range is made once
                return f"{head} {{\n{i} = $at;\n{self._block(body)}\n}}"
            case ast.Return(value):
                return f"return {self._value(value)};" if value else "return;"
            case ast.Raise(ast.Call(_, [ast.Constant(str() as why)])):
                return f"throw new Error({literal(why)});"
            case ast.Break() | ast.Continue():
                return f"{type(node).__name__.lower()};"
        self._refuse(node, f"“{ast.unparse(node).splitlines()[0]}”")

    def _stays_inside(self, name: str, loop: ast.For) -> None:
        """Refuse a loop whose variable is changed in it; after it, it has its last value in both languages."""
        for node in (inner for statement in loop.body for inner in ast.walk(statement)):
            if (
                isinstance(node, ast.Name)
                and node.id == name
                and isinstance(node.ctx, ast.Store)
            ):
                self._refuse(node, f"a loop that changes its own {name}")

    def _assign(self, target: ast.expr, value: str) -> str:
        match target:
            case ast.Subscript(array, ast.Slice(None, None, None)):
                return f"{self._value(array)}.fill({value});"
            case ast.Subscript(array, index) if is_row(target):
                return f"{self._value(array)}[{self._value(index)}].fill({value});"
        return f"{self._value(target)} = {value};"

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
                return f"[{', '.join(map(self._value, parts))}]"
            case ast.BinOp(left, operator, right):
                return self._operation(
                    self._number(left), operator, self._number(right), node
                )
            case ast.UnaryOp(ast.USub() as operator, operand) if (
                ast.USub in self.arithmetic
            ):
                return f"{self.arithmetic[ast.USub]}({self._number(operand)})"
            case ast.UnaryOp(operator, operand):
                return f"({self._operator(operator, node)}{self._number(operand)})"
            case ast.BoolOp(operator, values):
                return f"({f' {self._operator(operator, node)} '.join(map(self._number, values))})"
            case ast.Compare(left, operators, others) if not any(
                isinstance(n, ast.Tuple) for n in [left, *others]
            ):
                pairs = zip([left, *others], operators, others, strict=False)
                said = [
                    f"{self._number(a)} {self._operator(by, node)} {self._number(b)}"
                    for a, by, b in pairs
                ]
                return f"({' && '.join(said)})"
            case ast.IfExp(test, body, otherwise):
                return f"({self._number(test)} ? {self._value(body)} : {self._value(otherwise)})"
            case ast.Attribute(ast.Name("math"), word) if word in OF_MATH:
                return OF_MATH[word]
            case ast.Attribute(record, field) if field not in NOT_TRANSLATED:
                return f"{self._value(record)}.{field}"
            case ast.Subscript(
                ast.Attribute(array, "shape"), ast.Constant(int(axis))
            ) if not self._is_record(array):
                return f"{self._value(array)}{'[0]' * axis}.length"
            case ast.Subscript(array, ast.Tuple([row, column])):
                return (
                    f"{self._value(array)}[{self._value(row)}][{self._value(column)}]"
                )
            case ast.Subscript(array, index) if not isinstance(
                index, ast.Slice
            ) and not is_negative(index):
                return f"{self._value(array)}[{self._value(index)}]"
            case ast.Call(ast.Attribute(array, method), [], []) if (
                method in OF_AN_ARRAY
            ):
                return f"{method}_of({self._value(array)})"
            case ast.Call(ast.Attribute(_, method)) if method in NOT_TRANSLATED:
                self._refuse(node, f"“{ast.unparse(node)}”")
            case ast.Call(function, arguments, []):
                if self._value(function) in {*WORDS.values(), *OF_MATH.values()}:
                    arguments_text = ", ".join(map(self._number, arguments))
                    return f"{self._value(function)}({arguments_text})"
                return (
                    f"{self._value(function)}({', '.join(map(self._value, arguments))})"
                )
        self._refuse(node, f"“{ast.unparse(node)}”")

    def _is_record(self, node: ast.expr) -> bool:
        return isinstance(node, ast.Name) and node.id in self.records

    def _name(self, name: str, node: ast.AST) -> str:
        if name not in self.around:
            return name
        if self.around[name] is getattr(builtins, name, None):
            return WORDS[name] if name in WORDS else self._refuse(node, name)
        return self.name_of(self.around[name]) or self._refuse(node, name)
