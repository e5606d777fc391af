"""What a lesson prints of the library is its code, without the docstring, and it says nothing else."""

import ast
import inspect

import pytest

from rlrobot_course.library_code import library_code
from rlrobot_edu.learning import traces
from rlrobot_edu.learning.algorithms import sarsa_lambda, true_online_sarsa
from rlrobot_edu.learning.selections import qbiassr

PRINTED = [sarsa_lambda.update, traces.pass_on, true_online_sarsa.update, qbiassr.compute_bias]


def without_docstring(source: str) -> str:
    (definition,) = ast.parse(source).body
    assert isinstance(definition, ast.FunctionDef) and ast.get_docstring(definition)
    definition.body = definition.body[1:]
    return ast.dump(definition)


@pytest.mark.parametrize("function", PRINTED)
def test_the_docstring_is_gone_and_nothing_else(function):
    printed, source = library_code(function), inspect.getsource(getattr(function, "py_func", function))
    assert ast.dump(ast.parse(printed).body[0]) == without_docstring(source)
    assert set(printed.splitlines()) <= set(source.splitlines()), "line by line as it was written"


def test_a_function_without_a_docstring_stays_as_it_is():
    assert library_code(without_docstring) == inspect.getsource(without_docstring).rstrip()
