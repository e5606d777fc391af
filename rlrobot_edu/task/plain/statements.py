"""Statements of a plain function, in the text that is the same for Python, numba and JavaScript."""

import ast
from collections.abc import Sequence

from rlrobot_edu.task.plain.expressions import Expressions, variable
from rlrobot_edu.task.plain.names import NUMBER, is_local
from rlrobot_edu.task.plain.source import Definition


def body_of(definition: Definition, expressions: Expressions) -> list[ast.stmt]:
    """The statements of a function whose arguments `expressions` knows. Raises NotPlainError."""
    if isinstance(definition, ast.Lambda):
        return [ast.Return(expressions.number(definition.body))]
    body, ends = _block(definition.body, expressions)
    if not ends:
        expressions.refuse(
            definition, f"{definition.name}, which may end without a return,"
        )
    return body


def _block(
    statements: Sequence[ast.stmt], expressions: Expressions
) -> tuple[list[ast.stmt], bool]:
    """Plain statements, and whether the function surely returns in them."""
    written: list[ast.stmt] = []
    for statement in statements:
        if isinstance(statement, ast.Return):
            value = statement.value or ast.Constant(None)
            written.append(ast.Return(expressions.number(value)))
            return written, True  # what follows is never reached
        if isinstance(statement, ast.If):
            choice, ends = _choice(statement, expressions)
            written.append(choice)
            if ends:
                return written, True
        elif not _does_nothing(statement):
            written.append(_assignment(statement, expressions))
    return written or [ast.Pass()], False


def _does_nothing(statement: ast.stmt) -> bool:
    """Whether a statement is `pass` or a docstring."""
    if isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant):
        return isinstance(statement.value.value, str)
    return isinstance(statement, ast.Pass)


def _choice(statement: ast.If, expressions: Expressions) -> tuple[ast.If, bool]:
    """An `if` with all its branches, and whether the function returns in each of them."""
    test = expressions.condition(statement.test)
    before = set(expressions.assigned)
    body, body_ends = _block(statement.body, expressions)
    after_body = expressions.assigned
    expressions.assigned = before
    rest, rest_ends = _block(statement.orelse, expressions)
    if not statement.orelse:
        rest = []
    if rest_ends:
        expressions.assigned = after_body
    elif not body_ends:
        expressions.assigned = after_body & expressions.assigned
    return ast.If(test, body, rest), body_ends and rest_ends


def _assignment(statement: ast.stmt, expressions: Expressions) -> ast.stmt:
    """One name, or several at once, given numbers."""
    match statement:
        case ast.Assign([ast.Tuple(targets)], ast.Tuple(values)) if len(targets) == len(
            values
        ):
            numbers = [expressions.number(value) for value in values]
            names = [_assigned(target, expressions) for target in targets]
            return ast.Assign([ast.Tuple(names)], ast.Tuple(numbers))
        case ast.Assign([target], value) | ast.AnnAssign(
            target, _, ast.expr() as value
        ):
            number = expressions.number(value)
        case ast.AugAssign(ast.Name(name) as target, operator, value):
            old = expressions.number(ast.Name(name, lineno=statement.lineno))
            change = expressions.number(value)
            number = expressions.operation(old, operator, change, statement)
        case _:
            expressions.refuse(statement)
    return ast.Assign([_assigned(target, expressions)], number)


def _assigned(target: ast.expr, expressions: Expressions) -> ast.expr:
    """What is assigned to: a name of the function's own, which has a value from now on."""
    if not isinstance(target, ast.Name):
        expressions.refuse(target)
    if not is_local(expressions.function.__code__, target.id):
        expressions.refuse(target, f"“{target.id}”, which is a name of outside,")
    if expressions.kinds.get(target.id, NUMBER) != NUMBER:
        expressions.refuse(target, f"another value for “{target.id}”")
    expressions.assigned.add(target.id)
    return ast.Name(variable(target.id))
