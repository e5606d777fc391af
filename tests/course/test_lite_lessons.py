"""The lessons as `make lite` writes them: with smaller numbers, and with saved outputs of what no browser can run."""

import ast
import json
import re
from pathlib import Path

import make_lite
import pytest

from rlrobot_course.learner.my_course import blank

ROOT = Path(__file__).parents[2]
NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))
COMMENTED = re.compile(
    r"^(\w+) = \d+  # in the browser; elsewhere (\d+)$", re.MULTILINE
)


@pytest.fixture(scope="module")
def lessons(tmp_path_factory):
    """The lessons for the browser, by name."""
    folder = tmp_path_factory.mktemp("lite") / "content"
    make_lite.write_lessons(folder, NOTEBOOKS)
    return {
        path.stem: json.loads(path.read_text(encoding="utf-8"))
        for path in sorted(folder.glob("*.ipynb"))
    }


def code_of(notebook):
    return {
        cell["id"]: "".join(cell["source"])
        for cell in notebook["cells"]
        if cell["cell_type"] == "code"
    }


def test_every_lesson_of_the_road_is_there_installs_the_toolkit_first_and_its_code_is_code(
    lessons,
):
    assert list(lessons) == [path.stem for path in NOTEBOOKS]
    for notebook in lessons.values():
        first, *others = code_of(notebook).values()
        assert first == make_lite.INSTALL
        assert all(
            not cell["outputs"]
            for cell in notebook["cells"]
            if cell["cell_type"] == "code"
        )
        for source in others:
            ast.parse(re.sub(r"^%%writefile .*", "", source))


def test_a_lesson_differs_in_the_numbers_of_lessons_toml_and_each_says_so(lessons):
    smaller = make_lite.smaller_numbers()
    assert set(smaller) <= set(lessons)
    for path in NOTEBOOKS:
        elsewhere, changed = code_of(blank(path)), {}
        for cell, source in code_of(lessons[path.stem]).items():
            changed |= dict(COMMENTED.findall(source))
            if cell != "install":
                assert COMMENTED.sub(r"\1 = \2", source) == elsewhere[cell]
        assert list(changed) == list(smaller.get(path.stem, {}))
        assert all(
            smaller[path.stem][name] < int(larger) for name, larger in changed.items()
        )


def test_what_a_cell_needs_that_does_not_run_there_is_not_used_by_one_that_does(
    lessons,
):
    """A name that only cells with the tag assign is read by none of the others."""
    for path in NOTEBOOKS:
        here = code_of(lessons[path.stem])
        left_out = {
            cell: source
            for cell, source in code_of(blank(path)).items()
            if cell not in here
        }
        missing = names(left_out.values(), ast.Store) - names(here.values(), ast.Store)
        assert missing.isdisjoint(names(here.values(), ast.Load))


def names(sources, context):
    """The names that code assigns or imports (`ast.Store`), or reads (`ast.Load`)."""
    found = set()
    for node in (
        node
        for source in sources
        for node in ast.walk(ast.parse(re.sub(r"^%%.*", "", source)))
    ):
        match node:
            case ast.Name() if isinstance(node.ctx, context):
                found.add(node.id)
            case ast.arg(arg=name) if context is ast.Store:
                found.add(name)
            case ast.FunctionDef() | ast.alias() if context is ast.Store:
                found.add(getattr(node, "asname", None) or node.name)
    return found


def test_a_cell_that_needs_a_second_process_is_a_text_with_what_it_did(lessons):
    notebook = lessons["18_real_robot"]
    texts = [
        "".join(cell["source"])
        for cell in notebook["cells"]
        if cell["cell_type"] == "markdown"
    ]
    assert any(
        "kill_a_driver(" in text and "said after that: 0.0000 m/s" in text
        for text in texts
    )
    assert any(
        "listen(" in text and "odom: x =" in text and "<img" in text for text in texts
    )
    assert "ServedRobot" not in "".join(code_of(notebook).values())


@pytest.mark.parametrize("name", ["no_such_name", "step"])
def test_a_number_that_a_lesson_does_not_assign_exactly_once_is_refused(name):
    with pytest.raises(ValueError, match="assign once"):
        make_lite.in_browser(NOTEBOOKS[0], {name: 1})


def test_a_folder_without_the_pyodide_that_is_needed_is_refused(tmp_path):
    (tmp_path / "pyodide-lock.json").write_text('{"info": {"abi_version": "2024_0"}}')
    for folder in (tmp_path, tmp_path / "no folder"):
        with pytest.raises(ValueError, match=r"pyodide-314\.0\.6\.tar\.bz2"):
            make_lite.bring_pyodide(folder, tmp_path)
