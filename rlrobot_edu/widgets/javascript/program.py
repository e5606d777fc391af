"""A kernel with all that it calls, as one self-contained JavaScript expression; and rewards and goals as kernels."""

import ast
from collections.abc import Callable, Collection, Mapping
from itertools import count
from typing import Any

from rlrobot_edu.task.plain import functions_of, task_text
from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.javascript.translator import Translator
from rlrobot_edu.widgets.javascript.vocabulary import OF_MATH, literal

# What Python has and JavaScript lacks. The remainder has the sign of the divisor; the first of several largest counts.
PRELUDE = """
const remainder = (a, b) => a - b * Math.floor(a / b);
function max_of(array) {
let most = array[0];
for (const x of array) if (x > most) most = x;
return most;
}
function min_of(array) {
let least = array[0];
for (const x of array) if (x < least) least = x;
return least;
}
function argmax_of(array) {
let at = 0;
for (let i = 1; i < array.length; i++) if (array[i] > array[at]) at = i;
return at;
}
""".strip()


def program(
    kernels: Mapping[str, Callable[..., Any]],
    arithmetic: Mapping[type[ast.AST], str] | None = None,
) -> str:
    """An expression whose value is an object with these kernels, by their names.

    An array of two dimensions is to be given as an array of rows, a record as an object, a generator of random numbers
    as an object with a method ``random``. arithmetic: see `Translator`.

    Raises
    ------
    ValueError
        If something in a kernel, or in one that it calls, has no translation; the message gives file and line.
    """
    names: dict[Any, str] = {}
    texts: list[str] = []

    def name_of(thing: Any) -> str | None:
        """The JavaScript for what a kernel calls or reads: a function's name, after its text; a number; null."""
        if thing is None or isinstance(thing, int | float):
            return literal(thing)
        if getattr(thing, "__module__", "") == "math":
            return OF_MATH.get(thing.__name__)
        function = getattr(thing, "py_func", thing)
        if not hasattr(function, "__code__"):
            return None
        if function not in names:
            name = _free_name(function.__name__, names.values())
            names[function] = name
            texts.append(Translator(function, name_of, arithmetic).translate(name))
        return names[function]

    fields = [f"{name}: {name_of(kernel)}" for name, kernel in kernels.items()]
    given = f"return {{{', '.join(fields)}}};"
    return "\n".join(["(() => {", '"use strict";', PRELUDE, *texts, given, "})()"])


def _free_name(name: str, taken: Collection[str]) -> str:
    """This name, or with a number if it is taken: each algorithm's file has an ``update``."""
    if name not in taken:
        return name
    return next(f"{name}{i}" for i in count(1) if f"{name}{i}" not in taken)


def rewards_of(task: Task, suffix: str = "") -> dict[str, Callable[..., Any]]:
    """A task's reward and goal as `program` takes them: ``reward`` and, if there is one, ``goal``, with this suffix.

    Raises
    ------
    NotPlainError
        If one of them is not plain, see `rlrobot_edu.task.plain`; the message gives file and line.
    """
    functions = functions_of(task_text(task, suffix=suffix))
    names = [f"reward{suffix}"]
    if task.goal is not None:
        names.append(f"goal{suffix}")
    return {name: functions[name] for name in names}
