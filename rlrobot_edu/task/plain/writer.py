"""Plain functions as the text of a module, the same for Python, numba and JavaScript."""

import ast
import inspect
import linecache
from collections.abc import Callable, Collection, Mapping, Sequence
from types import FunctionType
from typing import Any, NoReturn

from rlrobot_edu.files import sha256
from rlrobot_edu.task.plain.expressions import Expressions, called, literal, variable
from rlrobot_edu.task.plain.names import (
    NUMBER,
    READINGS,
    Kind,
    plain_number,
    unusual,
    why_no_number,
)
from rlrobot_edu.task.plain.source import NotPlainError, definition_of, place
from rlrobot_edu.task.plain.statements import body_of
from rlrobot_edu.task.robot_cards import ROBOTS
from rlrobot_edu.task.task import Task

HEAD = "from rlrobot_edu.task.plain.arithmetic import divided, exact, larger, root, rounded, smaller\n"
LONGEST = 50_000  # characters; numba takes seconds for as many


def plain_text(
    rewards: Mapping[str, Callable[..., Any]],
    goals: Mapping[str, Callable[..., Any]],
    readings: Collection[str] | None = None,
) -> str:
    """The text of a module with these rewards and goals, and with all that they call.

    Parameters
    ----------
    rewards, goals : Mapping
        Functions of a task, by the names that they are to have in the module. There, a reward takes the readings before
        and after a step and returns a float, never −0.0; a goal takes readings and returns a bool.
    readings : collection of str, optional
        The names that readings have; None for any.

    Returns
    -------
    str
        The text. Where one of its functions raises, Python has to call the task's own, which may raise or go on.

    Raises
    ------
    NotPlainError
        If a function is not plain, see `rlrobot_edu.task.plain`; the message names file, line and reason.
    """
    module = _Module(readings)
    for name, function in rewards.items():
        value = module.first_call(function, ["before", "after"])
        module.add(name, ["before", "after"], f"{value} + 0.0")
    for name, function in goals.items():
        value = module.first_call(function, ["readings"])
        module.add(name, ["readings"], f"{value} != 0.0")
    return "\n\n".join([HEAD, *module.texts])


def task_text(
    task: Task, readings: Collection[str] | None = None, suffix: str = ""
) -> str:
    """The text of a module with ``reward`` and, for a task that has one, ``goal``; both names end with `suffix`.

    readings: the names that readings have; None for those of the robot's card
    Raises NotPlainError.
    """
    goals = {} if task.goal is None else {f"goal{suffix}": task.goal}
    names = ROBOTS[task.robot].sensors if readings is None else readings
    return plain_text({f"reward{suffix}": task.reward}, goals, names)


def functions_of(text: str) -> dict[str, FunctionType]:
    """The functions of a text that `plain_text` wrote, as Python has them, by name."""
    file = f"<plain functions {sha256(text.encode())[:12]}>"
    # where Python looks for the lines of a function
    linecache.cache[file] = len(text), None, text.splitlines(keepends=True), file
    space: dict[str, Any] = {"__name__": "plain_functions"}
    exec(compile(text, file, "exec"), space)
    functions = {}
    for value in space.values():
        if isinstance(value, FunctionType) and value.__code__.co_filename == file:
            functions[value.__name__] = value
    return functions


class _Module:
    """Writes functions one by one, each after those that it calls.

    texts: of the functions written so far
    readings: the names that readings have; None for any
    """

    def __init__(self, readings: Collection[str] | None) -> None:
        self.texts: list[str] = []
        self.readings = None if readings is None else frozenset(readings)
        # by the function and what its arguments are
        self._names: dict[tuple[FunctionType, tuple[Kind, ...]], str] = {}
        self._unfinished: list[FunctionType] = []

    def add(self, name: str, arguments: Sequence[str], value: str) -> None:
        """Add a function that returns the value of this expression."""
        self.texts.append(f"def {name}({', '.join(arguments)}):\n    return {value}\n")

    def first_call(self, function: Any, arguments: Sequence[str]) -> str:
        """The call of a task's function with readings of these names."""
        if not isinstance(function, FunctionType):
            raise NotPlainError(f"{function!r:.60} is not plain: write a function")

        def refuse(what: str) -> NoReturn:
            raise NotPlainError(f"{place(function)}: {what} is not plain")

        def as_readings(node: ast.expr) -> tuple[Kind, ast.expr]:
            return READINGS, node

        names = [ast.Name(argument) for argument in arguments]
        return ast.unparse(self.call(function, names, {}, as_readings, refuse))

    def call(
        self,
        function: FunctionType,
        given: Sequence[ast.expr],
        by_name: Mapping[str, ast.expr],
        argument: Callable[[ast.expr], tuple[Kind, ast.expr]],
        refuse: Callable[[str], NoReturn],
    ) -> ast.expr:
        """The call of a function, which is written first if it is not there yet.

        given, by_name: its arguments, as the caller has them
        argument: the kind of one of these, and the plain expression for it
        refuse: raises NotPlainError that names the line of the call
        """
        reason = unusual(function)
        if reason:
            raise NotPlainError(
                f"{place(function)}: {function.__name__}, {reason}, is not plain"
            )
        if "**" in by_name or any(isinstance(node, ast.Starred) for node in given):
            refuse("a call with * or **")
        signature = inspect.signature(function)
        try:
            bound = signature.bind(*given, **by_name).arguments
        except TypeError as error:
            refuse(f"this call of {function.__name__} ({error})")
        kinds = []
        written = []
        for name, parameter in signature.parameters.items():
            if name in bound:
                kind, value = argument(bound[name])
            else:
                kind, value = _default(function, name, parameter.default)
            kinds.append(kind)
            if kind.what != "text":
                written.append(value)
        return called(self._name_of(function, tuple(kinds), refuse), *written)

    def _name_of(
        self,
        function: FunctionType,
        kinds: tuple[Kind, ...],
        refuse: Callable[[str], NoReturn],
    ) -> str:
        """The name of a function for arguments of these kinds."""
        key = function, kinds
        if key not in self._names:
            if function in self._unfinished:
                refuse(f"{function.__name__}, which calls itself,")
            self._unfinished.append(function)
            try:
                text = self._written(function, kinds)
            except RecursionError:
                refuse(f"{function.__name__}, in which too much is nested,")
            self._unfinished.pop()
            length = len(text) + sum(map(len, self.texts))
            if length > LONGEST:
                refuse(
                    f"{function.__name__}, which is too long with all that it calls,"
                )
            name = function.__code__.co_name.replace("<lambda>", "function")
            unique = f"{name}_{len(self._names)}"
            self._names[key] = unique
            self.texts.append(text.replace("def _(", f"def {unique}(", 1))
        return self._names[key]

    def _written(self, function: FunctionType, kinds: tuple[Kind, ...]) -> str:
        """The text of a function with the name _."""
        named = dict(zip(inspect.signature(function).parameters, kinds, strict=True))
        given = [name for name, kind in named.items() if kind.what != "text"]
        body = body_of(definition_of(function), Expressions(function, named, self))
        module = ast.fix_missing_locations(ast.Module(body, []))
        arguments = ", ".join(variable(name) for name in given)
        lines = [f"def _({arguments}):"]
        for line in ast.unparse(module).splitlines():
            lines.append(f"    {line}")
        return "\n".join(lines) + "\n"


def _default(function: FunctionType, name: str, value: object) -> tuple[Kind, ast.expr]:
    """What an argument is that is not given: its default."""
    if type(value) is str:
        return Kind("text", value), ast.Constant(value)
    number = plain_number(value)
    if number is None:
        raise NotPlainError(
            f"{place(function)}: the default of {name} is not plain; {why_no_number(value)}"
        )
    return NUMBER, literal(number)
