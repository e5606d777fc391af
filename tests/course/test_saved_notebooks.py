"""A notebook that was saved comes back whole: no output shows a widget that is not in the file."""

import copy
import json
from pathlib import Path
from types import SimpleNamespace

import nbformat
import pytest
from imports import imports_of
from nbclient import NotebookClient

from rlrobot_course.learner import saving
from rlrobot_course.learner.saving import (
    STATE,
    VIEW,
    dead_views,
    drop_dead_views,
    drop_where_a_picture_is,
)

ROOT = Path(__file__).parents[2]
PACKAGES = ("rlrobot_edu", "rlrobot_ros", "rlrobot_grading", "rlrobot_course")
SAVED = sorted(
    path.relative_to(ROOT).as_posix() for path in ROOT.glob("notebooks/**/*.ipynb")
)
BARS = [
    """
import rlrobot_edu as rl
from rlrobot_edu.learning import loop
from rlrobot_edu.learning.progress import progress_bar

def at_once(*given, **named):
    return progress_bar(*given, **named, delay=0)

loop.progress_bar = at_once
env = rl.make_env("worked_example", seed=0)
rl.learn(rl.Agent(env, seed=0), env, steps=30);
""",
    'rl.repeat("worked_example", repetitions=3, steps=30, n_jobs=1);',
    """
try:
    with progress_bar(5, shown=True, delay=0, desc="<stopped>") as bar:
        bar.update(2)
        raise KeyboardInterrupt
except KeyboardInterrupt:
    pass
""",
    """
going_on = progress_bar(5, shown=True, delay=0, desc="<going on>")
going_on.update(2)
going_on.refresh();
""",
]


@pytest.fixture(scope="module")
def with_bars():
    """A notebook in which bars were shown, with the state of its widgets, as JupyterLab saves it."""
    cells = [nbformat.v4.new_code_cell(source) for source in BARS]
    notebook = nbformat.v4.new_notebook(cells=cells)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("RLROBOT_EDU_PROGRESS", "1")
        patch.setenv("PYTHONPATH", str(ROOT))
        NotebookClient(notebook, kernel_name="python3").execute()
    return notebook


@pytest.mark.parametrize("name", SAVED)
def test_every_widget_of_a_committed_notebook_is_in_the_file(name):
    assert dead_views(nbformat.read(ROOT / name, as_version=4)) == []


def test_bars_leave_no_widget_behind(with_bars):
    assert dead_views(with_bars) == []
    for cell in with_bars.cells:
        assert {output.output_type for output in cell.outputs} <= {"display_data"}


@pytest.mark.parametrize("number", [0, 1, 2])
def test_a_bar_that_has_closed_leaves_an_empty_output(with_bars, number):
    (output,) = with_bars.cells[number].outputs
    assert output.data == {"text/html": "", "text/plain": ""}


def test_a_bar_that_was_saved_while_it_ran_says_how_far_it_was(with_bars):
    (output,) = with_bars.cells[3].outputs
    assert 'max="5" value="2"' in output.data["text/html"]
    assert "&lt;going on&gt;: 40 %, 2 of 5" in output.data["text/html"]
    assert output.data["text/plain"].startswith("<going on>: 40 %, 2 of 5")


def test_all_bars_of_the_packages_are_made_in_one_place():
    files = set()
    for package in PACKAGES:
        files |= imports_of(package).get("tqdm", set())
    assert files == {"rlrobot_edu/learning/progress.py"}


def output_with(model_id, **more):
    data = {
        VIEW: {"model_id": model_id, "version_major": 2, "version_minor": 0},
        **more,
    }
    return {"output_type": "display_data", "metadata": {}, "data": data}


def saved(*outputs, models=()):
    """A notebook as Jupyter's server is about to save it."""
    state = {"state": {model: {} for model in models}}
    widgets = {STATE: state} if models else {}
    cells = [
        {"cell_type": "markdown", "source": "", "metadata": {}},
        {"cell_type": "code", "source": "", "outputs": list(outputs), "metadata": {}},
    ]
    metadata = {"widgets": widgets} if widgets else {}
    return {"type": "notebook", "content": {"cells": cells, "metadata": metadata}}


def test_after_a_restart_pictures_are_saved_in_place_of_widgets():
    model = saved(output_with("gone", **{"text/html": "<img>"}))
    drop_dead_views(model=model, path="x.ipynb", contents_manager=None)
    (output,) = model["content"]["cells"][1]["outputs"]
    assert output["data"] == {"text/html": "<img>"}


def test_a_widget_whose_state_is_saved_stays():
    model = saved(output_with("here", **{"text/html": "<img>"}), models=["here"])
    before = copy.deepcopy(model)
    drop_dead_views(model=model)
    assert model == before


@pytest.mark.parametrize("kind", ["file", "directory"])
def test_what_is_no_notebook_is_saved_as_it_is(kind):
    model = {"type": kind, "content": "cells"}
    drop_dead_views(model=model)
    assert model == {"type": kind, "content": "cells"}


def test_in_any_jupyter_a_view_goes_only_where_a_picture_stands_beside_it():
    ours = output_with("gone", **{"text/html": "<img>"})
    of_others = output_with("lost", **{"text/plain": "IntSlider()"})
    model = saved(ours, of_others)
    drop_where_a_picture_is(model=model, path="x.ipynb", contents_manager=None)
    left = [output["data"] for output in model["content"]["cells"][1]["outputs"]]
    assert VIEW not in left[0] and VIEW in left[1]
    folder = {"type": "directory", "content": []}
    drop_where_a_picture_is(model=folder)
    assert folder == {"type": "directory", "content": []}


def test_a_jupyter_server_that_finds_the_package_uses_it():
    """What the wheel puts into Jupyter's folder names a module that the server can load."""
    told = json.loads((ROOT / "rlrobot_course/learner/jupyter.json").read_text())
    (name,) = told["ServerApp"]["jpserver_extensions"]
    assert name == saving.__name__
    assert saving._jupyter_server_extension_points() == [{"module": name}]
    hooks = []
    contents = SimpleNamespace(register_pre_save_hook=hooks.append)
    saving._load_jupyter_server_extension(SimpleNamespace(contents_manager=contents))
    assert hooks == [drop_where_a_picture_is]
