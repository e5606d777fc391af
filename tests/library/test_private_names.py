"""What numba and pymunk do not document may change with any version of theirs: the project does without such names."""

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FOLDERS = (
    "rlrobot_edu",
    "rlrobot_course",
    "rlrobot_grading",
    "rlrobot_ros",
    "studies",
    "tasks",
    "tests",
)
# numba documents this one module of its core: https://numba.readthedocs.io/en/stable/developer/event_api.html
DOCUMENTED = "numba.core.event"
# Parts of modules' names that numba documents nowhere
INNER_MODULES = {"core", "function_type", "serialize", "caching", "compiler"}
# Attributes of numba's dispatchers and compiled functions, and of pymunk's spaces, bodies and shapes
INNER_ATTRIBUTES = {
    "numba": {
        "CompileResult",
        "CompileResultWAP",
        "_cache",
        "_can_compile",
        "_compiler",
        "_defn",
        "_make_finalizer",
        "get_call_template",
        "nopython_signatures",
        "overloads",
        "targetoptions",
    },
    "pymunk": {"_body", "_shape", "_space"},
}
# Where one is worth its price; a comment in the file says in numbers what it is worth.
WORTH_IT = {
    "rlrobot_edu/robots/mobile_base.py": {
        "pymunk._chipmunk.ffi",
        "pymunk._chipmunk.lib",
        "_body",
        "_space",
    }
}


def private_names(source, library):
    """The private names of `library` in this code, each with its line."""
    for node in ast.walk(ast.parse(source)):
        for name in named(node):
            if is_private(name, library):
                yield node.lineno, name
        is_attribute = isinstance(node, ast.Attribute)
        if is_attribute and node.attr in INNER_ATTRIBUTES[library] and not is_own(node):
            yield node.lineno, node.attr


def named(node):
    """What an import, or a chain of attributes, names in full."""
    match node:
        case ast.Import():
            return [alias.name for alias in node.names]
        case ast.ImportFrom(module=str(module), level=0):
            return [f"{module}.{alias.name}" for alias in node.names]
        case ast.Attribute():
            return [ast.unparse(node)]
    return []


def is_private(name, library):
    first, *parts = name.split(".")
    if first != library or name.startswith(DOCUMENTED) or name == "numba.core":
        return False  # numba.core alone is the beginning of a longer name, which is looked at, too
    return any(
        part in INNER_MODULES
        or part in INNER_ATTRIBUTES[library]
        or (part.startswith("_") and not part.endswith("__"))
        for part in parts
    )


def is_own(node):
    """Whether it is an attribute of our own object, which may have any name."""
    return isinstance(node.value, ast.Name) and node.value.id in {"self", "cls"}


def found(library):
    """The private names in each file of the project, and where they are."""
    names, places = {}, []
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*.py")):
            file = path.relative_to(ROOT).as_posix()
            for line, name in private_names(path.read_text("utf-8"), library):
                names.setdefault(file, set()).add(name)
                places.append(f"{file}:{line}: {name}")
    return names, "\n".join(places)


def test_no_private_name_of_numba_is_used():
    names, places = found("numba")
    assert not names, places


def test_private_names_of_pymunk_are_used_only_where_a_number_says_what_they_are_worth():
    names, places = found("pymunk")
    # the tests of served robots and of arms have bodies of our own
    ours = {"tests/ros/test_link_safety.py", "tests/robots/test_bullet_base.py"}
    assert {file: names[file] for file in names.keys() - ours} == WORTH_IT, places
    for file in WORTH_IT:
        assert "fewer steps a second (median of" in (ROOT / file).read_text("utf-8")


@pytest.mark.parametrize(
    ("library", "code"),
    [
        ("numba", "from numba.core.caching import NullCache"),
        ("numba", "import numba.core.compiler"),
        ("numba", "from numba.core import serialize"),
        ("numba", "numba.types.function_type.CompileResultWAP(x)"),
        ("numba", "dispatcher._cache = None"),
        ("numba", "kernel.overloads[types]"),
        ("numba", "numba._version"),
        ("pymunk", "from pymunk._chipmunk import lib"),
        ("pymunk", "self._space._space"),
        ("pymunk", "body._body"),
    ],
)
def test_a_private_name_is_seen(library, code):
    assert list(private_names(code, library))


@pytest.mark.parametrize(
    ("library", "code"),
    [
        ("numba", "from numba.core import event"),
        ("numba", "import numba.core.event"),
        ("numba", "numba.core.event.install_listener(kind, listener)"),
        ("numba", "numba.njit(f); numba.types.Tuple(x); numba.extending.overload"),
        ("numba", "numba.__version__; self._cache = 3; kernel.py_func"),
        ("pymunk", "space.step(dt); self._space = pymunk.Space()"),
    ],
)
def test_a_public_name_may_be_used(library, code):
    assert not list(private_names(code, library))
