"""The docstrings of the public names: in numpydoc's form, and about what is there to be given, returned and raised."""

import ast
import builtins
import inspect
import re
import textwrap
from contextlib import suppress
from pkgutil import resolve_name
from typing import Any, get_type_hints

from numpydoc.docscrape import NumpyDocString
from numpydoc.validate import validate

import rlrobot_edu as rl
from rlrobot_edu.missing_names import ELSEWHERE

# What must hold: a summary, every parameter documented, none that is not there, in the order of the signature, with a
# type; and what is returned is said. What numpydoc asks besides (examples, extended summaries, full stops) is taste.
CODES = {
    "GL08": "no docstring",
    "GL06": "unknown section",
    "GL07": "sections in the wrong order",
    "SS03": "no full stop after the summary",
    "PR01": "a parameter is not documented",
    "PR02": "a documented parameter does not exist",
    "PR03": "parameters in another order than in the signature",
    "PR04": "a parameter without a type",
    "PR07": "a parameter without a description",
    "RT03": "a return value without a description",
}
NEVER = {
    "rlrobot_edu.widgets.bias_explorer.explorer.BiasExplorer.still: no Raises of ValueError"
}  # it asks for a stage that there is


def public_names() -> list[str]:
    """Full names of the public functions and classes, and of the methods and properties that these define.

    Also of those that are not offered by `rlrobot_edu`, but named there.
    """
    elsewhere = [f"{module}.{name}" for name, module in ELSEWHERE.items()]
    mine = [name for name in elsewhere if name.startswith("rlrobot_edu.")]
    names = []
    for name in [*(f"rlrobot_edu.{name}" for name in rl.__all__), *mine]:
        names.append(name)
        thing = resolve_name(name)
        if inspect.isclass(thing):
            names += [f"{name}.{key}" for key, value in inspect.getmembers(thing)
                      if function_of(value) and not key.startswith("_")]  # fmt: skip
    return names


def function_of(thing: Any) -> Any:
    """The function of the library behind a function, method or property, or that makes a class; None for another."""
    if inspect.isclass(thing):
        thing = getattr(thing, "__post_init__", thing.__init__)
    for behind in ("__func__", "fget", "func", "py_func"):
        thing = getattr(thing, behind, thing)
    if inspect.isfunction(thing):
        thing = inspect.unwrap(thing)  # as it was before it suggested keywords
    is_ours = inspect.isfunction(thing) and thing.__code__.co_filename.startswith(
        rl.__path__[0]
    )
    return thing if is_ours else None


def exceptions_of(
    thing: Any, owner: Any, is_called: bool = False
) -> set[type[BaseException]]:
    """What a thing raises, or what it calls of the library does, one level deep; what stands in a try may be caught."""
    if (function := function_of(thing)) is None:
        return set()
    tree = ast.parse(textwrap.dedent(inspect.getsource(function)))
    tries = [
        node for node in ast.walk(tree) if isinstance(node, ast.Try) and node.handlers
    ]
    caught = {node for each in tries for line in each.body for node in ast.walk(line)}
    names = {**vars(builtins), **function.__globals__, "self": owner, "cls": owner}
    found = set()
    for node in set(ast.walk(tree)) - caught:
        called = getattr(node, "exc", node)
        is_plain = isinstance(called, ast.Call) and re.fullmatch(
            r"[\w.]+", ast.unparse(called.func)
        )
        with suppress(
            NameError, AttributeError
        ):  # a name that is local, or an attribute of an object
            value = eval(ast.unparse(called.func), names) if is_plain else None
            if isinstance(node, ast.Raise) and value is not None:
                is_kind = inspect.isclass(value)
                # a function that makes the error says which
                found.add(value if is_kind else get_type_hints(value)["return"])
            elif not is_called:
                found |= exceptions_of(
                    value, value if inspect.isclass(value) else owner, is_called=True
                )
    return found - {NotImplementedError}


def faults_of(name: str) -> list[str]:
    """What is wrong with a docstring, a line each."""
    checked = validate(name)
    faults = [f"{code} {said}" for code, said in checked["errors"] if code in CODES]
    thing, sections = resolve_name(name), NumpyDocString(checked["docstring"])
    is_method = inspect.isfunction(thing) or inspect.ismethod(
        thing
    )  # numpydoc's RT01 passes over class methods
    if is_method and thing.__annotations__["return"] not in (None, "None"):
        faults += [] if sections["Returns"] + sections["Yields"] else ["no Returns"]
    said = {each.type.rpartition(".")[2] for each in sections["Raises"]}
    for raised in exceptions_of(thing, owner=resolve_name(name.rpartition(".")[0])):
        if not said & {kind.__name__ for kind in raised.__mro__}:
            faults.append(f"no Raises of {raised.__name__}")
    if re.search(r"\b[Rr]aises? \w*Error", checked["docstring"]):
        faults.append("Raises is not a section")
    return [f"{name}: {fault}" for fault in faults]


def test_every_public_docstring_is_in_numpydocs_form_and_says_what_is_returned_and_raised():
    faults = {line for name in public_names() for line in faults_of(name)} - NEVER
    assert not faults, f"{len(faults)} faults\n" + "\n".join(sorted(faults))
