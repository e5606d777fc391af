"""A misspelt keyword is answered with the nearest one that exists, which Python itself does only from 3.13 on."""

from collections.abc import Callable, Sequence
from functools import wraps
from inspect import Parameter, signature
from types import FunctionType
from typing import Any, TypeVar

from rlrobot_edu.checks import did_you_mean

T = TypeVar("T", bound=Callable[..., Any])
BY_NAME = (Parameter.POSITIONAL_OR_KEYWORD, Parameter.KEYWORD_ONLY)


def suggests_keywords(called: T) -> T:
    """`called`, whose TypeError for a keyword that it does not have suggests the nearest one.

    called: a function, or a class. A class is changed in place: how it is made, and its public methods that have
    options; the others are called by position, and often. If arguments are missing, it names its other makers.
    """
    if isinstance(called, FunctionType):
        suggesting: T = _suggesting(called, called.__name__)
        return suggesting
    # A named tuple is made by __new__.
    maker = "__init__" if "__init__" in vars(called) else "__new__"
    others = []
    for name, member in list(vars(called).items()):
        if name.startswith("_"):
            continue
        if isinstance(member, classmethod):
            others.append(f"{called.__name__}.{name}")
            setattr(called, name, classmethod(_suggesting(member.__func__, name)))
        elif isinstance(member, FunctionType) and _has_options(member):
            setattr(called, name, _suggesting(member, name))
    make = vars(called)[maker]
    setattr(called, maker, _suggesting(make, called.__name__, others))
    return called


def names_of(function: Callable[..., Any]) -> list[str]:
    """The arguments of a function or method that can be given by name."""
    parameters = signature(function).parameters.values()
    names = [parameter.name for parameter in parameters if parameter.kind in BY_NAME]
    return [name for name in names if name not in ("self", "cls", "_cls")]


def _has_options(function: Callable[..., Any]) -> bool:
    """Whether one of its arguments may be left out."""
    parameters = signature(function).parameters.values()
    return any(parameter.default is not Parameter.empty for parameter in parameters)


def _suggesting(function: Any, name: str, others: Sequence[str] = ()) -> Any:
    """The function; it looks at the arguments first.

    name: what its caller calls it; others: other ways to make what it makes
    """
    names = names_of(function)
    required = []
    for parameter in signature(function).parameters.values():
        if parameter.kind in BY_NAME and parameter.default is Parameter.empty:
            required.append(parameter.name)

    @wraps(function)
    def suggesting(*arguments: Any, **named: Any) -> Any:
        for given in named:
            if given not in names:
                nearest = did_you_mean(given, names)
                raise TypeError(
                    f"{name}() has no argument {given!r}{nearest} It has: {', '.join(names)}"
                )
        by_name = required[len(arguments) :]
        missing = [needed for needed in by_name if needed not in named]
        if missing and others:
            makers = " or ".join(others)
            raise TypeError(f"{name}() needs {', '.join(missing)}; {makers} makes one")
        return function(*arguments, **named)

    return suggesting
