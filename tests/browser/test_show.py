"""What is drawn, written and served to show a robot's world, from scenes made up here."""

import asyncio
import base64
import dataclasses
import html
import io
import json
import math
import re
import subprocess
import sys
import time
import warnings
import zlib

import gymnasium
import meshcat
import numpy as np
import pytest
import umsgpack
from matplotlib.figure import Figure
from matplotlib.text import Text
from PIL import Image, ImageColor
from waiting import until

import rlrobot_edu as rl
from rlrobot_edu.installing import to_install
from rlrobot_edu.learning.history import History, Learned
from rlrobot_edu.learning.size import Size
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.robots.chassis import PIONEER
from rlrobot_edu.robots.scene import Scene, Solid, pose
from rlrobot_edu.show.curves import plot_learning
from rlrobot_edu.show.film import WIDTH, Film, film
from rlrobot_edu.show.in3d import looks
from rlrobot_edu.show.in3d.page_widget import PAUSE
from rlrobot_edu.show.in3d.replay import telling
from rlrobot_edu.show.in3d.visualizer import show_scene
from rlrobot_edu.show.palette import DARK, LIGHT, ROLE
from rlrobot_edu.show.picture import Picture
from rlrobot_edu.show.style import SMALLEST
from rlrobot_edu.show.top_down import footprint, plot_scene
from rlrobot_edu.widgets.sliders import ParameterSliders


def scene(angle: float = 0.0) -> Scene:
    """A room of 2 by 2 metres in which a robot has come `angle` [rad] along a circle."""
    at = pose(0, 0, 0, angle) @ pose(0.5, 0, 0.13, math.pi / 2)
    beams = [
        (at[:3, 3] + 0.22 * way, at[:3, 3] + 0.3 * way)
        for way in (at[:3, 0], at[:3, 1], -at[:3, 1])
    ]
    solids = (
        Solid("wall/north", "box", (2, 0.04, 0.3), pose(0, 1, 0.15), "wall"),
        Solid("wall/west", "box", (0.04, 2, 0.3), pose(-1, 0, 0.15), "wall"),
        Solid("goal", "cylinder", (0.2, 0.01), pose(-0.7, 0.7, 0), "goal"),
        Solid("object", "sphere", (0.05,), pose(0.8, -0.8, 0.05), "object"),
        Solid("robot/body", "cylinder", (0.22, 0.2), at, "robot"),
        Solid("robot/wheel", "box", (0.2, 0.04, 0.2), at @ pose(0, 0.165, 0), "wheel"),
    )
    return Scene(solids, np.array(beams), (-1, -1, 1, 1))


SCENES = [scene(0.1 * i) for i in range(20)]
FILM = Film(SCENES, [10.0 if i % 3 else -2.0 for i in range(20)])


def shown(data: dict[str, str]) -> tuple[str, str, bytes]:
    """Alt text, kind of file and file of the picture in what a notebook keeps."""
    alt, mime, file = re.search(
        r'<img alt="([^"]*)".*? src="data:([^;]*);base64,([^"]*)"', data["text/html"]
    ).groups()
    return html.unescape(alt), mime, base64.b64decode(file)


def commands_of(view) -> dict[tuple[str, str, str], dict]:
    """What a view's page is told, by path, kind and property."""
    return {key: umsgpack.unpackb(packed) for key, packed in view.window.commands()}


def pose_of(command: dict) -> np.ndarray:
    """The matrix of a set_transform."""
    return np.reshape(command["matrix"], (4, 4)).T


def test_the_shadow_of_each_shape_has_its_size():
    sizes = [(2, 0.04), (0.04, 2), (0.4, 0.4), (0.1, 0.1), (0.44, 0.44)]
    for solid, size in zip(scene().solids[:5], sizes, strict=True):
        assert np.allclose(np.ptp(footprint(solid), axis=0), size)
    quarter_turn = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])
    lying = Solid("w", "cylinder", (0.1, 0.04), quarter_turn, "wheel")
    assert np.allclose(np.ptp(footprint(lying), axis=0), (0.2, 0.04))
    hull = Solid("h", *PIONEER.body(), pose(1, 2, 0.16), "robot")
    assert {tuple(corner) for corner in footprint(hull)} == {
        (1 + x, 2 + y) for x, y in PIONEER.hull
    }


def test_a_picture_shows_walls_robot_beams_and_the_whole_path():
    ax = plot_scene(SCENES).axes[0]
    assert {"wall/north", "robot/body", "robot/wheel", "goal"} <= {
        patch.get_label() for patch in ax.patches
    }
    (beams,) = ax.collections
    assert len(beams.get_segments()) == 3
    (path,) = [line for line in ax.lines if line.get_label() == "path"]
    assert np.allclose(path.get_xydata(), [s.solids[4].pose[:2, 3] for s in SCENES])
    assert (ax.axison, ax.get_aspect()) == (False, 1)
    assert "1 m" in [text.get_text() for text in ax.texts], (
        "no bar says how large it is"
    )


def test_a_part_of_a_room_is_drawn_without_a_warning():
    picture = Picture((5, 5))
    ax = picture.subplots()
    plot_scene(scene(), ax)
    ax.set(xlim=(0, 0.5), ylim=(0, 0.5))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert picture.png()


def test_a_picture_goes_where_it_is_told_and_refuses_nothing_at_all():
    ax = plot_scene(scene()).axes[0]
    assert plot_scene(SCENES, ax=ax, title="Here") is ax and ax.get_title() == "Here"
    with pytest.raises(ValueError, match="one scene or several"):
        plot_scene([])


def test_the_same_film_gives_the_same_small_gif(tmp_path):
    FILM.save(tmp_path / "film.gif")
    gif = FILM.gif()
    assert gif == FILM.gif() == (tmp_path / "film.gif").read_bytes()
    assert [file.name for file in tmp_path.iterdir()] == ["film.gif"]
    picture = Image.open(io.BytesIO(gif))
    assert (picture.n_frames, picture.width) == (20, WIDTH)
    assert picture.info["loop"] == 0 and picture.info["duration"] == 150
    assert len(gif) < 20 * 4000


def test_a_film_shows_itself_as_a_gif_with_a_description():
    data = FILM._repr_mimebundle_()
    alt, mime, file = shown(data)
    assert mime == "image/gif" and file[:6] == b"GIF89a"
    assert data["text/plain"] == "<Film of 20 steps>" and "20 steps" in alt


def test_a_world_without_a_robot_cannot_be_filmed():
    env = gymnasium.make("FrozenLake-v1")
    with pytest.raises(ValueError, match="no robot to look at"):
        film(rl.Agent(env), env)


def test_a_still_page_works_offline_and_holds_the_scene():
    view = rl.meshcat(scene())
    assert isinstance(view, meshcat.Visualizer)
    library, commands, rewards = unpacked(view.html)
    assert (
        not re.search(r"<(script|link|img)[^>]+(src|href)", view.html)
        and "MeshCat" in library
        and rewards == []
    )
    told = [umsgpack.unpackb(command) for command in commands]
    assert told == list(commands_of(view).values())
    body = commands_of(view)["/meshcat/robot/body", "set_transform", ""]
    assert np.allclose(pose_of(body), scene().solids[4].pose)


def unpacked(page: str) -> tuple[str, list[bytes], list[float]]:
    """What a page holds: meshcat's viewer, its commands, the rewards."""

    def text(name: str) -> str:
        return re.search(f'id="{name}" type="text/plain">(.*)</script>', page)[1]

    def part(name: str) -> bytes:
        return zlib.decompress(base64.b64decode(text(name)))

    commands = umsgpack.unpackb(part("scene"))
    return part("library").decode(), commands, json.loads(text("paid"))


def test_a_saved_notebook_keeps_a_small_picture_and_words(tmp_path):
    view = show_scene(SCENES, FILM.rewards)
    assert repr(view) == repr(show_scene(SCENES)) and "20 steps" in repr(view)
    view.save(tmp_path / "room.html")
    assert (
        unpacked((tmp_path / "room.html").read_text(encoding="utf-8"))[2]
        == FILM.rewards
    )
    data = view._repr_mimebundle_()
    assert (
        sum(len(str(value)) for value in data.values()) < 50_000
        and data["text/plain"] == view.text
    )
    assert shown(data)[0] == view.text


def replay_of(view) -> tuple[dict, dict[str, np.ndarray]]:
    """The replay of a view's page, and of everything that moves in it the places, arrays (n scenes, 3, 4)."""
    told = commands_of(view)["", "replay", ""]
    numbers = np.frombuffer(told["moves"], dtype="<f4")
    moves = numbers.reshape(len(told["names"]), 3, 4, -1).transpose(0, 3, 1, 2)
    return told, dict(zip(told["names"], moves, strict=True))


def test_a_replay_holds_where_everything_is_in_every_scene():
    told, places = replay_of(show_scene(SCENES, FILM.rewards))
    assert "wall/north" not in places
    assert told["rate"] == pytest.approx(1 / 0.15)
    for i, each in enumerate(SCENES):
        body = each.solids[4].pose
        assert np.allclose(places["robot/body"][i], body[:3], atol=1e-6)
        start, end = each.beams[2]
        beam = places["beams/2"][i]
        assert np.allclose(beam[:, 3], (start + end) / 2, atol=1e-6)
        length = np.linalg.norm(beam[:, 1])
        assert length == pytest.approx(np.linalg.norm(end - start), rel=1e-5)
    with pytest.raises(ValueError, match="3 rewards for 20 scenes"):
        show_scene(SCENES, FILM.rewards[:3])


def test_what_a_scene_does_not_hold_is_nowhere_in_a_replay():
    without_ball = scene()._replace(solids=(*scene().solids[:3], *scene().solids[4:]))
    _, places = replay_of(show_scene([without_ball, scene(0.1)]))
    assert np.isnan(places["object"][0]).all()
    assert np.isfinite(places["object"][1]).all()


def test_what_a_user_adds_is_in_the_running_scene_and_in_its_page():
    env = rl.make_env("worked_example", seed=0)
    view, heard = rl.meshcat(env), []
    view.window.listeners.append(lambda key, packed: heard.append(key))
    rl.meshcat(env)["extra"].set_object(meshcat.geometry.Box([1, 1, 1]))
    env.reset()
    env.step(0)
    assert rl.meshcat(env) is view and ("/meshcat/extra", "set_object", "") in heard
    assert ("/meshcat/robot/body", "set_transform", "") in heard
    assert ("/meshcat/extra", "set_object", "") in commands_of(view)
    view["extra"].delete()
    assert not [key for key in commands_of(view) if key[0].startswith("/meshcat/extra")]
    assert rl.meshcat(rl.make_env("worked_example", seed=0)) is not view
    for wish in (view.open, view.url, view.wait):
        with pytest.raises(RuntimeError, match="no server: show it in a notebook"):
            wish()


def test_a_notebook_is_sent_what_is_new_in_few_messages():
    view = rl.meshcat(scene())
    sent = []
    view.widget.send = lambda told, buffers: sent.append((told, buffers))
    first = view.widget.get_state("scene")["scene"]
    commands = umsgpack.unpackb(zlib.decompress(first["packed"]))
    assert len(commands) == len(view.window.commands())
    assert first["keys"] == first["news"] == []

    async def move():
        begun = time.monotonic()
        for i in range(199):
            view.update(scene(0.01 * i), reward=1.0)
        assert 1 <= len(sent) <= 1 + (time.monotonic() - begun) / PAUSE
        before = len(sent)
        time.sleep(
            2 * PAUSE
        )  # as in a cell that runs on: nothing else is called meanwhile
        view.update(scene(1.99), reward=1.0)
        assert len(sent) > before
        await asyncio.sleep(4 * PAUSE)

    asyncio.run(move())
    told = sent[-1][0] | {"keys": [key for news, _ in sent for key in news["keys"]]}
    news = {
        key: packed
        for each, buffers in sent
        for key, packed in zip(each["keys"], buffers, strict=True)
    }
    place = news["/meshcat/robot/body", "set_transform", ""]
    assert np.allclose(pose_of(umsgpack.unpackb(place)), scene(1.99).solids[4].pose)
    assert told["count"] == 200 and told["rewards"] == 200 * [1.0]
    assert (
        len(
            {
                key[0]
                for key in told["keys"]
                if re.fullmatch("/meshcat/trail/[0-9]+", key[0])
            }
        )
        == 10
    )
    assert view.widget.get_state("scene")["scene"]["count"] == 200, (
        "so a page that comes back has no hole"
    )


IN_COLAB = """
import sys, types
widgets = types.SimpleNamespace(_installed_url="https://colab/manager")
output = types.SimpleNamespace(enable_custom_widget_manager=lambda: None, _widgets=widgets)
sys.modules["google.colab.output"] = output
import rlrobot_edu as rl
env = rl.make_env("worked_example", seed=0)
for view in (rl.meshcat(env), rl.Stepper(rl.Agent(env, "Q+SR", seed=0), env)):
    data, metadata = view._repr_mimebundle_()
    mime = "application/vnd.jupyter.widget-view+json"
    assert data["text/html"].startswith("<img") and mime in data
    print(metadata[mime]["colab"]["custom_widget_manager"]["url"][:8])
"""


def test_colab_is_told_where_its_widgets_come_from():
    run = subprocess.run(
        [sys.executable, "-c", IN_COLAB], capture_output=True, text=True
    )
    assert run.stdout.splitlines() == 2 * ["https://"], run.stderr


def test_another_room_takes_the_place_of_the_old_one():
    view = rl.meshcat(scene())
    view.update(scene()._replace(solids=scene().solids[1:]), reward=1.0)
    paths = {key[0] for key in commands_of(view)}
    assert (
        "/meshcat/wall/west/body" in paths and "/meshcat/wall/north/body" not in paths
    )


def history(method: str, seed: int, steps: int = 50) -> History:
    """A process of random rewards in which nothing was learned."""
    return history_of(np.random.default_rng(seed).normal(size=steps), method)


def history_of(rewards: np.ndarray, method: str = "Q+SR") -> History:
    transitions = Transitions.empty(len(rewards))._replace(r=rewards)
    nothing = Learned.of(np.zeros((1, 1)), np.zeros((1, 1), dtype=int))
    return History(method, transitions.without_states(), nothing, 0.0, Size((1,), 1))


def test_curves_may_have_the_same_name():
    one, two, three = (history("Q+SR", seed) for seed in range(3))
    (ax,) = plot_learning(one, two).axes
    assert sorted(line.get_linestyle() for line in ax.lines) == ["-", "--"]
    (ax,) = plot_learning(one, two, three).axes
    assert len({line.get_color() for line in ax.lines}) == 3


def test_curves_are_named_and_differ_by_more_than_their_colour():
    repetitions = [history("TOSL+SR", seed) for seed in range(5)]
    figure = plot_learning(history("Q+SR", 9), repetitions)
    (ax,) = figure.axes
    means = [line for line in ax.lines if line.get_linestyle() != "None"]
    assert sorted(line.get_linestyle() for line in means) == ["-", "--"]
    named = [text.get_text().split("\n")[0] for text in ax.texts]
    assert sorted(named) == ["Q+SR", "TOSL+SR"]
    _, note = figure.texts
    assert "95 %" in note.get_text() and "average reward" in note.get_text()
    assert ax.get_xlabel() == "step"
    assert len(ax.collections) == 1
    assert np.allclose(
        means[1].get_ydata(),
        np.mean([h.average_reward for h in repetitions], axis=0),
    )


def test_a_figure_says_in_words_what_it_shows():
    alt, mime, file = shown(plot_learning(history("Q+SR", 9))._repr_mimebundle_())
    assert mime == "image/png" and "Q+SR ends at" in alt
    assert Image.open(io.BytesIO(file)).size == (2 * 585, 2 * 378), (
        "twice as fine as it is shown"
    )


def test_signs_in_an_alt_text_are_no_html():
    picture = Picture(alt='Q < 0 & "so on"')
    assert html.unescape(picture.still().html.split('"')[1]) == picture.alt


def test_no_letters_of_a_figure_are_too_small():
    picture = Picture((2, 2))
    picture.subplots().set_title("small", fontsize=5)
    picture.text(0, 0, "large", fontsize=20)
    picture.png()
    assert {text.get_fontsize() for text in picture.findobj(Text)} >= {SMALLEST, 20}
    assert min(text.get_fontsize() for text in picture.findobj(Text)) == SMALLEST


def test_the_leap_at_the_start_does_not_squeeze_the_rest_of_a_curve():
    ax = Figure().subplots()
    rewards = np.full(1000, 1.0)
    rewards[0], rewards[500:] = 100.0, 2.0
    plot_learning(history_of(rewards), ax=ax)
    low, high = ax.get_ylim()
    assert 0 < low < 1.2 and 2 < high < 7, (
        "from step 20 on: 100 at the start is off the picture"
    )
    ax = Figure().subplots()
    plot_learning(history_of(np.linspace(0, 1, 1000)), ax=ax)
    assert ax.get_ylim()[0] <= 0, "where nothing leaps, all is shown"


def test_a_slider_changes_the_curve_and_the_saved_still_is_the_first_one(wander_model):
    sliders = ParameterSliders(wander_model, steps=300, repetitions=2)
    first = sliders.widget.children[-1].value
    data = sliders._repr_mimebundle_()
    assert data["text/html"] == first and "temperature 1" in shown(data)[0]
    sliders.sliders["temperature"].value = 30.0
    second = sliders.widget.children[-1].value
    sliders.sliders["lam"].value = 0.0
    assert len({first, second, sliders.widget.children[-1].value}) == 3


def test_sliders_are_those_that_were_asked_for(wander_model):
    sliders = ParameterSliders(
        wander_model, "Q+SR", ["alpha"], steps=300, repetitions=2
    )
    assert list(sliders.sliders) == ["alpha"]
    assert "1 slider, α" in sliders._repr_mimebundle_()["text/plain"]
    for parameters in (["beta"], [], "alpha"):
        with pytest.raises(ValueError, match="some of alpha, gamma, lam, temperature"):
            ParameterSliders(wander_model, "Q+SR", parameters)


def test_sliders_refuse_a_world_that_is_too_slow_to_follow_them():
    with pytest.raises(ValueError, match="a SampleModel; got a str"):
        ParameterSliders("wander_1k")


def test_curves_that_cannot_be_drawn_are_refused_in_words():
    with pytest.raises(ValueError, match="a History of at least 1 step"):
        plot_learning([])
    with pytest.raises(ValueError, match="1 labels for 2 curves"):
        plot_learning(history("Q+SR", 0), history("Q+SR", 1), labels=["one"])


WITHOUT_MESHCAT = """
import sys
for name in ("meshcat", "zmq", "umsgpack", "tornado"):
    sys.modules[name] = None
import rlrobot_edu as rl
from rlrobot_edu.show.film import Film
env = rl.make_env("wander_simple", seed=0)
agent = rl.Agent("wander_simple", seed=0)
film = rl.film(agent, env, steps=2)
assert film.gif()[:6] == b"GIF89a" and rl.plot_scene(film.frames).png()
for wish in (film.show3d, lambda: rl.meshcat(film), lambda: rl.watch(agent, env, steps=2)):
    try:
        wish()
    except ImportError as error:
        print(error)
"""


def test_without_meshcat_all_but_3d_works_and_3d_says_what_to_install():
    run = subprocess.run(
        [sys.executable, "-c", WITHOUT_MESHCAT], capture_output=True, text=True
    )
    assert run.returncode == 0, run.stderr
    assert run.stdout.splitlines() == 3 * [
        f"3D views need meshcat: run {to_install('notebook')}; everything else works without it"
    ]


def seen(page) -> Image.Image:
    """What is on the page; a robot must be among it."""
    picture = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
    blue = sum(n for n, (r, g, b) in picture.getcolors(1 << 24) if b > r + 90)
    assert blue > 100, "no robot to be seen"
    return picture


@pytest.fixture
def opened(browser, tmp_path):
    """Opens a view's page in a browser; it must go without errors."""
    pages, errors = [], []

    def opened(view, width: int = 480, height: int = 360):
        view.save(tmp_path / "view.html")
        page = browser.new_page(viewport={"width": width, "height": height})
        pages.append(page)
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.goto((tmp_path / "view.html").as_uri())
        return page

    yield opened
    for page in pages:
        page.close()
    assert errors == []


def test_a_browser_draws_the_replay_and_moves_it(opened):
    page = opened(show_scene(SCENES, FILM.rewards))
    until(page, "caption.textContent.startsWith('step 3 of 20: reward')")
    page.click("#play")
    page.evaluate("go(3)")
    until(page, "caption.textContent.startsWith('step 3 of 20')")
    first, trail = (
        seen(page),
        page.evaluate(
            "node(['meshcat', 'trail', '1', '<object>']).geometry.drawRange.count"
        ),
    )
    page.evaluate("go(16)")
    until(
        page,
        "caption.textContent === 'step 16 of 20: loss · reward −2 · sum so far +88' && chart.hidden",
    )
    until(page, f"Math.abs(body().position.x - {0.5 * math.cos(1.5)}) < 1e-6")
    assert seen(page).tobytes() != first.tobytes()
    assert (
        page.evaluate(
            "node(['meshcat', 'trail', '1', '<object>']).geometry.drawRange.count"
        )
        > trail
    )


def test_a_page_that_is_told_something_does_not_go_on_talking_to_itself(opened):
    page = opened(show_scene(SCENES))
    until(page, "last === 19")
    heard = """async () => {
        let times = 0;
        addEventListener("message", () => { times += 1; });
        postMessage({commands: [], rewards: [], count: 0}, "*");
        await new Promise(done => setTimeout(done, 1000));
        return times;
    }"""
    assert page.evaluate(heard) == 1


def test_a_page_without_rewards_tells_the_steps_alone(opened):
    page = opened(show_scene(SCENES))
    until(page, "last === 19")
    page.evaluate("go(16)")
    until(page, "caption.textContent === 'step 16 of 20' && chart.hidden")


INSIDE = """node(["meshcat", "robot"]).children.every(part => {
  const box = new MeshCat.THREE.Box3().setFromObject(part);
  return [box.min, box.max].every(p => { p.project(viewer.camera); return Math.abs(p.x) < 1 && Math.abs(p.y) < 1; });
})"""


@pytest.fixture
def carded(browser):
    """Opens a page of a film's card, as a saved notebook shows it, without scripts."""
    pages = []

    def carded(html, **settings):
        pages.append(browser.new_page(**settings))
        pages[-1].set_content(f"<html><body>{html}</body></html>")
        return pages[-1]

    yield carded
    for page in pages:
        page.close()


@pytest.mark.parametrize("motion", ["no-preference", "reduce"])
def test_a_saved_film_can_be_paused_and_waits_for_a_reader_who_wants_no_motion(
    carded, motion
):
    html = FILM._repr_mimebundle_()["text/html"]
    assert "<script" not in html
    page = carded(html, reduced_motion=motion)
    moves = page.locator("img[src^='data:image/gif']")
    stands = page.locator("img[src^='data:image/png']").last
    said = (
        "getComputedStyle(document.querySelector('.rl-film label'), '::after').content"
    )
    runs = motion == "no-preference"
    for _ in range(3):
        assert (moves.is_visible(), stands.is_visible()) == (runs, not runs)
        assert page.evaluate(said) == ('"‖ Pause"' if runs else '"▶ Play"')
        page.get_by_role("checkbox").focus()
        page.keyboard.press(" ")
        runs = not runs


def test_without_styles_a_saved_film_and_its_steps_are_both_shown(carded):
    html = FILM._repr_mimebundle_()["text/html"]
    page = carded(re.sub("<style>.*?</style>", "", html, flags=re.DOTALL))
    assert [image.is_visible() for image in page.locator("img").all()] == [True] * 5
    assert not page.get_by_role("checkbox").is_visible(), "it would do nothing"


@pytest.mark.parametrize(
    ("theme", "dark"),
    [("", True), ('data-jp-theme-light="true"', False), ('class="vscode-dark"', True)],
)
def test_the_card_of_a_film_is_light_or_dark_as_its_page_is(carded, theme, dark):
    html = f"<div {theme}>{FILM._repr_mimebundle_()['text/html']}</div>"
    page = carded(html, color_scheme="dark")
    ground = "getComputedStyle(document.querySelector('.rl-film')).backgroundColor"
    paper = (DARK if dark else LIGHT)["paper"]
    red, green, blue = ImageColor.getrgb(paper)
    assert page.evaluate(ground) == f"rgb({red}, {green}, {blue})"


def stands_of(view) -> list[dict]:
    told = [umsgpack.unpackb(packed) for _, packed in view.window.commands()]
    (found,) = [each["stands"] for each in told if each["type"] == "stands"]
    return found


def test_two_films_of_a_room_have_one_camera_wherever_their_robots_went():
    """So they can stand side by side; and so has a view of the room alone."""
    short = show_scene(walk("wander_1k", 8).frames)
    long = show_scene(walk("wander_1k", 60).frames)
    room = rl.meshcat(rl.make_env("wander_1k", seed=0))
    assert stands_of(short) == stands_of(long) == stands_of(room)


CORNERS = """(() => {
  viewer.render();
  const {Box3, Vector3} = MeshCat.THREE, box = new Box3(), parts = ["wall", "floor"];
  for (const part of parts.map(name => node(["meshcat", name])).filter(Boolean)) box.expandByObject(part);
  const {min, max} = box, tall = Math.min(max.y, 0.4);  // the world's y points upward
  const places = [min.x, max.x].flatMap(x => [min.z, max.z].flatMap(z => [min.y, tall].map(y => [x, y, z])));
  return places.map(place => new Vector3(...place).project(viewer.camera).toArray().slice(0, 2));
})()"""
SHAPES = [(1280, 800), (390, 844), (700, 700), (900, 420), (300, 280)]


@pytest.mark.parametrize("task", ["wander_1k", "arm_1k", "mobile_arm_2k"])
def test_no_corner_of_the_room_is_cut_off_on_a_picture_of_any_shape(opened, task):
    if "arm" in task:
        pytest.importorskip("pybullet")
    page = opened(show_scene(walk(task, 8).frames), *SHAPES[-1])
    until(page, "last === 7 && !bar.hidden")
    for width, height in SHAPES:
        page.set_viewport_size({"width": width, "height": height})
        drawn = "[view.clientWidth, view.clientHeight].join() === [c.clientWidth, c.clientHeight].join()"
        until(
            page,
            f"innerWidth === {width} && (c => {drawn})(viewer.renderer.domElement)",
        )
        across, down = np.abs(page.evaluate(CORNERS)).max(axis=0)
        assert max(across, down) < 1, (width, height)
        assert max(across, down) > 0.7, "it could stand nearer"
        if width < height:  # a phone has no void above and below the room
            assert page.evaluate("view.clientHeight") <= width and across > 0.85


def test_a_readers_own_view_stays_until_the_picture_has_another_shape(opened):
    page = opened(show_scene(SCENES, FILM.rewards), 900, 600)
    until(page, "last === 19 && !bar.hidden")
    page.evaluate("viewer.camera.position.set(1, 2, 3)")
    page.set_viewport_size({"width": 920, "height": 610})
    until(page, "view.clientWidth === 920")
    kept = page.evaluate("viewer.camera.position.toArray()")
    assert kept == pytest.approx([1, 2, 3])
    page.set_viewport_size({"width": 400, "height": 800})
    until(page, "Math.abs(viewer.camera.position.x - 1) > 0.01")


def test_without_motion_a_film_opens_at_the_last_step_that_earned_most(opened):
    assert telling([5, 10, -1, 10, -1]) == 3
    assert telling([-1, 0, -2]) == telling([]) == -1
    rewards = [0.0] * 20
    rewards[11] = 4.0
    view = show_scene(SCENES, rewards)
    page = opened(view)
    page.emulate_media(reduced_motion="reduce")
    page.reload()
    until(page, "last === 19 && caption.textContent.startsWith('step 12 of 20')")


def test_a_sign_on_the_slider_leads_to_its_moment_and_the_caption_names_it(opened):
    rewards = [10.0] * 20
    rewards[4] = rewards[15] = -2.0
    page = opened(show_scene(SCENES, rewards, task="Wander"), 390, 800)
    until(page, "last === 19 && marks.children.length === 2")
    told = "Wander: reward +10 in 18 of 20 steps, 2 losses (−2 each)"
    assert page.inner_text("h1") == told
    page.click("#marks span >> nth=0")
    until(page, "caption.textContent.startsWith('step 5 of 20: loss · reward −2')")
    thumb = page.evaluate(
        "time.getBoundingClientRect().left + 8 + (time.clientWidth - 16) * 4 / 19"
    )
    mark = page.locator("#marks span").first.bounding_box()
    assert mark["x"] - 1 < thumb < mark["x"] + 20


def test_a_walls_far_side_hides_the_way(opened):
    page = opened(show_scene(SCENES, FILM.rewards))
    until(page, "last === 19")
    band = "node(['meshcat', 'trail', '1', '<object>'])"
    until(page, f"{band}.material.depthTest")
    assert page.evaluate(f"{band}.children.length") == 0


def test_a_view_without_a_film_tells_how_it_fares_now(opened):
    view = rl.meshcat(scene())
    for i, reward in enumerate([10.0, -2.0, 10.0], start=1):
        view.update(scene(0.1 * i), reward)
    page = opened(view, 390, 800)
    until(page, "finding.textContent === 'Live: mean reward +6 over its last 3 steps'")
    room, curve = (page.locator(name).bounding_box() for name in ("#view", "#chart"))
    assert curve["y"] >= room["y"] + room["height"] - 1, "on a phone it hides nothing"


@pytest.mark.parametrize(
    "task",
    ["wander_1k", "giraff_wander_1k", "navigation_1k", "arm_1k", "mobile_arm_2k"],
)
def test_the_whole_robot_is_in_the_picture(opened, task):
    if "arm" in task:
        pytest.importorskip("pybullet")
    page = opened(rl.meshcat(rl.make_env(task, seed=0)), 600, 400)
    until(page, "typeof viewer === 'object' && !!body() && viewer.camera.aspect > 1")
    assert page.evaluate(INSIDE)


def test_a_hull_in_3d_is_closed_and_shows_its_outer_sides():
    base, height = np.array(PIONEER.hull), 0.16
    one, two, three = (
        np.reshape(looks.prism(base, height).vertices, (-1, 3, 3))
        .swapaxes(0, 1)
        .astype(float)
    )
    area = (
        np.sum(
            base[:, 0] * np.roll(base[:, 1], -1) - np.roll(base[:, 0], -1) * base[:, 1]
        )
        / 2
    )
    assert np.sum(one * np.cross(two, three)) / 6 == pytest.approx(
        area * height, rel=1e-5
    )  # the divergence theorem
    assert np.cross(two - one, three - one).sum(axis=0) == pytest.approx(
        np.zeros(3), abs=1e-6
    )


def test_the_wheel_zooms_only_after_a_click_and_the_chase_camera_follows_the_robot(
    opened,
):
    distance = "viewer.camera.position.length()"  # from where it looks
    page = opened(show_scene(SCENES, FILM.rewards), 500, 300)
    until(
        page,
        "last === 19 && !bar.hidden && view.clientHeight === viewer.renderer.domElement.clientHeight",
    )
    whole = page.evaluate(distance)
    page.mouse.move(100, 60)
    page.mouse.wheel(0, 300)
    until(page, "!hint.hidden")
    assert page.evaluate(distance) == pytest.approx(whole)
    page.mouse.click(100, 60)
    page.mouse.wheel(0, 300)
    until(page, f"Math.abs({distance} - {whole}) > 0.01 && hint.hidden")
    away = page.evaluate(distance)
    page.click("#chase")
    page.evaluate("go(11)")
    aim = "node(['Cameras', 'default']).position"
    until(
        page,
        f"Math.hypot({aim}.x - body().position.x, {aim}.y - body().position.y) < 1e-6",
    )
    assert page.evaluate(distance) < 0.8 * whole
    page.click("#chase")
    until(page, f"Math.abs({distance} - {away}) < 1e-6")


BODY_ON_SCREEN = """(() => {
  viewer.render();
  const box = new MeshCat.THREE.Box3().setFromObject(body());
  return box.getCenter(new MeshCat.THREE.Vector3()).project(viewer.camera).toArray().slice(0, 2);
})()"""


def walk(task: str, steps: int = 50) -> Film:
    env = rl.make_env(task, seed=0)
    return film(rl.Agent(task, "TOSL+QBIASSR", seed=0), env, steps=steps)


@pytest.mark.parametrize("task", ["wander_1k", "navigation_1k", "arm_1k"])
def test_the_chase_camera_keeps_the_robot_in_the_middle_of_the_picture(opened, task):
    """Seen through the viewer's own lens, far from the start and with the robot turned."""
    if "arm" in task:
        pytest.importorskip("pybullet")
    page = opened(walk(task).show3d(), 300, 240)
    until(page, "typeof last === 'number' && last === 49")
    page.click("#play")
    page.click("#chase")
    start = page.evaluate("body().position.toArray()")
    for step in (50, 25):
        page.evaluate(f"go({step})")
        until(page, f"number() === {step} && shown === at")
        x, y = page.evaluate(BODY_ON_SCREEN)
        assert abs(x) < 0.3 and abs(y) < 0.3, (step, x, y)
    if "arm" not in task:
        page.evaluate("go(50)")
        until(page, "shown === at")
        assert math.dist(page.evaluate("body().position.toArray()"), start) > 0.5


def test_the_chase_camera_keeps_a_robot_in_the_picture_that_is_watched_live(opened):
    env = rl.make_env("navigation_1k", seed=0)
    view = rl.meshcat(env)
    for one in walk("navigation_1k").frames:
        view.update(one, -0.1)
    page = opened(view, 300, 240)
    until(page, "typeof viewer === 'object' && !!body() && !chase.hidden")
    page.click("#chase")
    x, y = page.evaluate(BODY_ON_SCREEN)
    assert abs(x) < 0.3 and abs(y) < 0.3, (x, y)


def test_a_view_whose_picture_the_browser_took_has_it_again_when_it_is_seen(opened):
    """A browser takes the picture of the oldest view where there are more than it can draw."""
    page = opened(show_scene(SCENES, FILM.rewards), 300, 240)
    until(page, "typeof last === 'number' && last === 19")
    page.evaluate("viewer.renderer.forceContextLoss(); view.hidden = true")
    until(page, "isLost()")
    with page.expect_navigation():
        page.evaluate("view.hidden = false")
    until(page, "typeof last === 'number' && last === 19 && !isLost()")


@pytest.mark.parametrize("task", ["wander_1k", "navigation_1k"])
def test_the_front_wall_is_whole_in_the_picture_of_a_wide_window(opened, task):
    page = opened(rl.meshcat(rl.make_env(task, seed=0)), 1280, 800)
    until(page, "typeof viewer === 'object' && !!body() && viewer.camera.aspect > 1")
    lowest = """(() => {
      viewer.render();
      const walls = new MeshCat.THREE.Box3().setFromObject(node(["meshcat", "wall"]));
      const near = new MeshCat.THREE.Vector3(0, 0, walls.max.z).project(viewer.camera);
      return near.y;
    })()"""
    assert page.evaluate(lowest) > -1


def test_a_replay_knows_where_a_robot_was_put(opened):
    view = show_scene([scene(), scene(math.pi), scene(math.pi)])
    assert replay_of(view)[0]["put"] == [1]
    page = opened(view, 300, 240)
    until(page, "typeof last === 'number' && last === 2")
    page.evaluate("playing = false")
    where = "(viewer.animator.seek({} / rate), body().position.x)"
    assert page.evaluate(where.format(0.9)) == pytest.approx(0.5, abs=1e-3)
    assert page.evaluate(where.format(1)) == pytest.approx(-0.5, abs=1e-3)


def test_a_film_that_is_paused_stands_at_a_whole_step_and_beams_jump_from_step_to_step(
    opened,
):
    page = opened(show_scene(SCENES, FILM.rewards), 300, 240)
    until(page, "typeof last === 'number' && last === 19")
    page.evaluate("playing = true; at = 7.6; moves.play()")
    assert page.evaluate("at") == 8
    assert page.evaluate("number()") == 9
    ray = """(part) => {
      viewer.animator.seek(part / rate);
      return node(["meshcat", "beams", "0"]).position.toArray();
    }"""
    measured = page.evaluate(ray, 8)
    assert page.evaluate(ray, 8.5) == pytest.approx(measured)
    assert page.evaluate(ray, 9.01) != pytest.approx(measured)


def test_a_view_keeps_the_picture_of_our_own_painter():
    view = show_scene(SCENES)
    still = view.still()
    assert still.alt == view.text
    image = Image.open(io.BytesIO(still.data)).convert("RGB")
    blue = ImageColor.getrgb(ROLE["robot"])
    assert (np.asarray(image) == blue).all(axis=2).sum() > 100, "no robot"
    with pytest.raises(RuntimeError, match="this view has no server"):
        view.get_image()


def test_a_film_tells_what_is_noted_of_a_step_besides_its_reward():
    noted = dataclasses.replace(FILM, notes=[f"T = {i}" for i in range(20)])
    for with_note, without in zip(noted.pictures(), FILM.pictures(), strict=True):
        assert with_note.height > without.height


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"frames": []}, "film at least 1 step"),
        ({"frames": None}, "frames of a film must be a list of scenes, got None"),
        ({"frames": SCENES[0]}, "frames of a film must be a list of scenes, got Scene"),
        ({"frames": [1] * 20}, "frames of a film must be a list of scenes, got .1, 1"),
        ({"rewards": 3}, "rewards must be a list of numbers, got 3"),
        ({"rewards": ["much"] * 20}, "rewards must be a list of numbers"),
        ({"rewards": [1.0]}, "got 1 rewards for 20 scenes; give one for each"),
        ({"seconds_per_frame": 0}, "seconds_per_frame must be a number"),
        ({"notes": "T"}, "notes of a film must be a list of texts, got 'T'"),
        ({"notes": [1] * 20}, "notes of a film must be a list of texts"),
        ({"notes": ["T = 1"]}, "got 1 notes for 20 scenes; give one for each"),
    ],
)
def test_a_film_of_anything_else_is_refused_in_one_sentence(given, told):
    with pytest.raises(ValueError, match=told):
        dataclasses.replace(FILM, **given)


def test_a_beam_is_a_cylinder_from_its_start_to_its_end_even_without_a_length():
    rng = np.random.default_rng(0)
    for start, end in [
        *rng.normal(size=(20, 2, 3)),
        ((0, 0, 0), (0, 0, 1)),
        ((1, 2, 3), (1, 2, 3)),
    ]:
        place = looks.beam(np.array(start, dtype=float), np.array(end, dtype=float))
        turn = place[:3, :3] / np.linalg.norm(place[:3, :3], axis=0)
        assert np.allclose(turn.T @ turn, np.eye(3)) and np.linalg.det(
            turn
        ) == pytest.approx(1)
        assert np.allclose(place @ [0, 0.5, 0, 1], [*end, 1], atol=1e-5)
        assert np.allclose(place @ [0, -0.5, 0, 1], [*start, 1], atol=1e-5)
