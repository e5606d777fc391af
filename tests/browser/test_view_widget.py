"""Films and live views as widgets of a notebook: one viewer for all, little to save, and words if it is gone."""

import base64
import json
import math
import subprocess
import sys

import meshcat
import numpy as np
import pytest
from ipywidgets import Widget
from waiting import until

import rlrobot_edu as rl
from rlrobot_edu.show import film as film_module
from rlrobot_edu.show.describe import loss_of
from rlrobot_edu.show.film import Film
from rlrobot_edu.show.in3d.page_widget import ViewerWidget
from rlrobot_edu.show.in3d.visualizer import show_scene

VIEW = "application/vnd.jupyter.widget-view+json"


def walk(task: str, steps: int = 60) -> Film:
    env = rl.make_env(task, seed=0)
    return rl.film(rl.Agent(task, "TOSL+QBIASSR", seed=0), env, steps=steps)


@pytest.fixture
def in_notebook(monkeypatch):
    """As if a kernel ran this, and somebody watched."""
    monkeypatch.setattr(film_module, "in_a_notebook", lambda: True)
    monkeypatch.delenv("RLROBOT_EDU_PROGRESS", raising=False)


def saved_bytes() -> int:
    """Bytes that a notebook needs for all widgets of this process."""
    return len(json.dumps(Widget.get_manager_state(drop_defaults=True)))


def test_films_share_one_viewer_and_each_adds_some_kilobytes(in_notebook):
    first = walk("wander_1k")
    data = first._repr_mimebundle_()
    assert VIEW in data and "<img" in data["text/html"]
    before = saved_bytes()
    second = walk("wander_1k")
    assert second.widget.viewer is first.widget.viewer
    assert second.widget is second.widget
    assert saved_bytes() - before < 30_000


def test_a_viewer_that_somebody_has_closed_is_made_anew(in_notebook):
    first = walk("wander_simple", 3).widget.viewer
    first.close()
    again = walk("wander_simple", 3).widget.viewer
    assert again is not first and again.comm is not None


def test_a_film_that_nobody_watches_has_no_widget(in_notebook, monkeypatch):
    monkeypatch.setenv("RLROBOT_EDU_PROGRESS", "0")
    assert VIEW not in walk("wander_simple", 3)._repr_mimebundle_()


def test_outside_of_a_notebook_a_film_has_no_widget(monkeypatch):
    monkeypatch.delenv("RLROBOT_EDU_PROGRESS", raising=False)
    assert walk("wander_simple", 3).widget is None


WITHOUT = """
import os, sys
sys.modules["{package}"] = None
os.environ.pop("RLROBOT_EDU_PROGRESS", None)
import rlrobot_edu as rl
from rlrobot_edu.show import film
film.in_a_notebook = lambda: True
env = rl.make_env("wander_simple", seed=0)
shown = rl.film(rl.Agent("wander_simple", seed=0), env, steps=2)._repr_mimebundle_()
print(sorted(shown))
"""


@pytest.mark.parametrize("package", ["meshcat", "anywidget"])
def test_without_what_a_widget_needs_a_film_is_a_moving_picture(package):
    program = WITHOUT.format(package=package)
    run = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True
    )
    assert run.stdout == "['text/html', 'text/plain']\n", run.stderr


class Notebook:
    """A page of a browser that shows a widget as a notebook would; `arrive` takes what its kernel sends."""

    def __init__(self, page, widget, viewer: str | None):
        self._page = page
        self.errors = []
        page.on("pageerror", lambda error: self.errors.append(str(error)))
        page.set_content("<main></main>")
        code = widget._esm.replace("export default", "window.carried =")
        page.add_script_tag(content=code)
        scene = widget.get_state("scene")["scene"]
        scene["packed"] = base64.b64encode(scene["packed"]).decode()
        page.evaluate(
            """async ({scene, viewer}) => {
                const bytes = text => new DataView(Uint8Array.from(atob(text), sign => sign.charCodeAt()).buffer);
                window.told = {scene: {...scene, packed: bytes(scene.packed)}, height: 520, viewer: "IPY_MODEL_7"};
                window.hears = new Set();
                window.arrive = news => hears.forEach(hear => hear(news, news.packed.map(bytes)));
                const widget_manager = {get_model: async id => {
                    if (id !== "7" || !viewer) throw Error("model not found");
                    return {get: () => viewer};
                }};
                const model = { get: (name) => told[name], set: (name, value) => { told[name] = value; },
                    widget_manager, on: (_, hear) => hears.add(hear), off: (_, hear) => hears.delete(hear) };
                carried.initialize({ model });
                window.show = async () => carried.render({ model, el: document.querySelector('main') });
                window.hide = await show();
            }""",
            {"scene": scene, "viewer": viewer},
        )

    @property
    def frame(self):
        """The page of the view that is seen now."""
        return self._page.query_selector("iframe").content_frame()

    def arrive(self, sent) -> None:
        """Messages of the kernel come to the page."""
        for told, buffers in sent:
            packed = [base64.b64encode(each).decode() for each in buffers]
            self._page.evaluate("news => arrive(news)", {**told, "packed": packed})

    def open_again(self) -> None:
        """The view leaves the page and comes back, and the kernel says nothing more."""
        self._page.evaluate(
            "hide(); document.querySelector('main').replaceChildren(); void show()"
        )
        self._page.wait_for_selector("iframe")


@pytest.fixture
def shown(browser):
    """Shows a widget in a notebook's page; its programs must end without errors."""
    page = browser.new_page(viewport={"width": 480, "height": 400})
    opened = []

    def show(widget, viewer=None):
        opened.append(Notebook(page, widget, viewer))
        return opened[-1]

    yield show
    page.close()
    assert [each for one in opened for each in one.errors] == []


def sent_by(view) -> list:
    """What the widget of a view sends from now on."""
    sent = []
    view.widget.send = lambda told, buffers: sent.append((told, buffers))
    return sent


def test_a_carried_view_shows_what_came_before_it_and_what_comes_after(shown):
    frames = walk("navigation_1k", 12).frames
    view = rl.meshcat(frames[0])
    notebook = shown(view.widget, ViewerWidget.only().page)
    until(notebook.frame, "typeof viewer === 'object' && !!body()")
    sent = sent_by(view)
    view.update(frames[-1], reward=1.0)
    view["extra"].set_object(meshcat.geometry.Box([1, 1, 1]))
    view.widget.tell()
    notebook.arrive(sent)
    (x,) = [s.pose[0, 3] for s in frames[-1].solids if s.name == "robot/body"]
    moved = f"Math.abs(body().position.x - {x}) < 1e-6"
    words = "step 1: reward +1 · sum so far +1"
    until(notebook.frame, f"{moved} && caption.textContent === '{words}'")
    until(notebook.frame, "!!node(['meshcat', 'extra', '<object>'])")
    notebook.open_again()
    until(
        notebook.frame,
        f"typeof viewer === 'object' && !!body() && {moved} && count === 1",
    )


def test_what_was_watched_becomes_a_film_of_the_last_steps_until_it_goes_on(shown):
    frames = walk("wander_1k", 40).frames
    view = rl.meshcat(frames[0])
    notebook = shown(view.widget, ViewerWidget.only().page)
    until(notebook.frame, "typeof viewer === 'object' && !!body()")
    sent = sent_by(view)
    for one in frames:
        view.update(one, reward=1.0)
    view.look_back(frames[-10:], 0.15, "")
    view.widget.tell()
    notebook.arrive(sent)
    until(
        notebook.frame, "last === 9 && caption.textContent.startsWith('step 40 of 40')"
    )
    assert not notebook.frame.evaluate("playing")
    notebook.frame.evaluate("go(31)")
    until(notebook.frame, "caption.textContent.startsWith('step 31 of 40')")
    (x,) = [s.pose[0, 3] for s in frames[30].solids if s.name == "robot/body"]
    assert notebook.frame.evaluate("body().position.x") == pytest.approx(x, abs=1e-3)
    drawn = """Object.values(branch(["meshcat", "trail"]).children)
      .map(piece => piece.children["<object>"].object.geometry.drawRange.count)"""
    assert notebook.frame.evaluate(drawn) == [6 * 31, 6 * 11]
    sent.clear()
    view.update(frames[0], reward=-1.0)
    view.widget.tell()
    notebook.arrive(sent)
    until(notebook.frame, "last === 0 && caption.textContent.startsWith('step 41:')")


def test_a_view_whose_viewer_is_not_in_the_notebook_says_what_to_do(shown, browser):
    notebook = shown(show_scene(walk("wander_simple", 3).frames).widget)
    said = notebook._page.inner_text("main")
    assert said == "The view in 3D is not kept in this notebook: run this cell again."


def test_turn_goes_round_the_robot_and_keeps_its_distance(shown):
    view = show_scene(walk("wander_1k", 20).frames)
    notebook = shown(view.widget, ViewerWidget.only().page)
    frame = notebook.frame
    until(frame, "typeof last === 'number' && last === 19 && !bar.hidden")
    place = "viewer.camera.position.clone().sub(viewer.controls.target).toArray()"
    before = np.array(frame.evaluate(place))
    frame.click("#turn")
    until(frame, f"Math.abs(({place})[0] - {before[0]}) > 0.3")
    frame.click("#turn")
    after = np.array(frame.evaluate(place))
    assert np.linalg.norm(after) == pytest.approx(np.linalg.norm(before))
    assert math.isclose(after[1], before[1], abs_tol=1e-6)


def test_the_notes_of_a_film_stand_beside_its_rewards(shown):
    frames = walk("wander_simple", 3).frames
    noted = Film(frames, [1.0, 2.0, 3.0], notes=["T = 1", "T = 2", "T = 3"])
    notebook = shown(noted.show3d().widget, ViewerWidget.only().page)
    until(notebook.frame, "typeof last === 'number' && last === 2")
    notebook.frame.evaluate("go(2)")
    words = "step 2 of 3: reward +2 · sum so far +3 · T = 2"
    until(notebook.frame, f"caption.textContent === '{words}'")


def test_the_map_marks_no_bump_where_a_step_only_costs_a_little():
    assert loss_of([10.0, -0.02, 10.0]) is None
    assert loss_of([10.0, -0.02, -2.0]) == -2.0
    assert loss_of([]) is None


def test_the_map_shows_the_robot_where_it_is_at_this_step(shown):
    frames = walk("wander_1k", 20).frames
    notebook = shown(show_scene(frames).widget, ViewerWidget.only().page)
    frame = notebook.frame
    until(frame, "typeof last === 'number' && last === 19 && !bar.hidden")
    frame.evaluate("go(12)")
    frame.click("#flat")
    until(frame, "!plan.hidden && shown === at")
    (body,) = [s.pose for s in frames[11].solids if s.name == "robot/body"]
    heading = math.atan2(body[1, 0], body[0, 0])
    place = frame.evaluate("placeAt(number() - 1)")
    assert place == pytest.approx([body[0, 3], body[1, 3], heading], abs=1e-4)
    beam = frame.evaluate("beamAt('beams/0', number() - 1)")
    assert beam == pytest.approx(frames[11].beams[0, :, :2].ravel(), abs=1e-4)
    assert frame.evaluate("plan.width > 0 && plan.clientWidth > 0")
    frame.click("#flat")
    assert frame.evaluate("plan.hidden")
