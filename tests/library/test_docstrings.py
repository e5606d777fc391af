"""The docstrings of the public names: in numpydoc's form, and about the parameters that are there."""

import functools
import inspect
from typing import Any

from numpydoc.validate import validate

import rlrobot_edu as rl

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
    "RT01": "no Returns",
    "RT03": "a return value without a description",
    "YD01": "no Yields",
}


def public_functions() -> list[str]:
    """Full names of the public functions and classes, and of the methods that the classes define for their users."""
    names = []
    for name in rl.__all__:
        thing = getattr(rl, name)
        names.append(f"rlrobot_edu.{name}")
        if inspect.isclass(thing):
            for key, value in inspect.getmembers(thing, inspect.isroutine):
                is_ours = str(getattr(value, "__module__", "")).startswith("rlrobot_edu.")
                if is_ours and not key.startswith("_"):
                    names.append(f"rlrobot_edu.{name}.{key}")
    return names


def faults_of(name: str) -> list[str]:
    """What is wrong with a docstring, a line each. Where there is nothing to hand over, the summary may say it all."""
    checked, signature = validate(name), inspect.signature(thing_of(name))
    faults = [(code, said) for code, said in checked["errors"] if code in CODES]
    is_one_phrase = len(checked["docstring"].strip().splitlines()) == 1
    if is_one_phrase or not signature.parameters.keys() - {"self", "cls"}:
        faults = [(code, said) for code, said in faults if code not in ("RT01", "YD01")]
    return [f"{name}: {code} {said}" for code, said in faults]


def thing_of(name: str) -> Any:
    """The class or function of a full name."""
    return functools.reduce(getattr, name.split(".")[1:], rl)


def test_every_public_docstring_is_in_numpydocs_form():
    faults = [line for name in public_functions() for line in faults_of(name)]
    assert not faults, f"{len(faults)} faults\n" + "\n".join(faults)
