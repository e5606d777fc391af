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

import gymnasium
import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text
from own_thread import in_a_thread
from PIL import Image
from waiting import until

import rlrobot_edu as rl
from rlrobot_edu.learning.history import History, Learned
from rlrobot_edu.learning.size import Size
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.robots.mobile_base import PIONEER
from rlrobot_edu.robots.scene import Scene, Solid, pose
from rlrobot_edu.show.curves import plot_learning
from rlrobot_edu.show.film import Film, film
from rlrobot_edu.show.in3d.views import show_scene
from rlrobot_edu.show.picture import Picture
from rlrobot_edu.show.top_down import footprint, plot_scene
from rlrobot_edu.widgets.live_picture import REST
from rlrobot_edu.widgets.live_view import KEPT, LiveView
from rlrobot_edu.widgets.sliders import ParameterSliders


def scene(angle: float = 0.0) -> Scene:
    """A room of 2 by 2 metres in which a robot has come `angle` [rad] along a circle."""
    at = pose(0, 0, 0, angle) @ pose(0.5, 0, 0.13, math.pi / 2)
    beams = [(at[:3, 3] + 0.22 * way, at[:3, 3] + 0.3 * way) for way in (at[:3, 0], at[:3, 1], -at[:3, 1])]
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
    alt, mime, file = re.search(r'<img alt="([^"]*)".* src="data:([^;]*);base64,([^"]*)"', data["text/html"]).groups()
    return html.unescape(alt), mime, base64.b64decode(file)


def feed_of(page: str) -> dict:
    """What a page is told to draw."""
    return json.loads(re.search(r"const feed = (.*);\n", page)[1])


def test_the_shadow_of_each_shape_has_its_size():
    sizes = [(2, 0.04), (0.04, 2), (0.4, 0.4), (0.1, 0.1), (0.44, 0.44)]
    for solid, size in zip(scene().solids[:5], sizes, strict=True):
        assert np.allclose(np.ptp(footprint(solid), axis=0), size)
    quarter_turn = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])
    lying = Solid("w", "cylinder", (0.1, 0.04), quarter_turn, "wheel")
    assert np.allclose(np.ptp(footprint(lying), axis=0), (0.2, 0.04))
    hull = Solid("h", *PIONEER.body(), pose(1, 2, 0.16), "robot")
    assert {tuple(corner) for corner in footprint(hull)} == {(1 + x, 2 + y) for x, y in PIONEER.hull}


def test_a_picture_shows_walls_robot_beams_and_the_whole_path():
    ax = plot_scene(SCENES).axes[0]
    assert {"wall/north", "robot/body", "robot/wheel", "goal"} <= {patch.get_label() for patch in ax.patches}
    (beams,) = ax.collections
    assert len(beams.get_segments()) == 3
    (path,) = [line for line in ax.lines if line.get_label() == "path"]
    assert np.allclose(path.get_xydata(), [s.solids[4].pose[:2, 3] for s in SCENES])
    assert (ax.get_xlabel(), ax.get_ylabel(), ax.get_aspect()) == ("x (m)", "y (m)", 1)


def test_a_picture_goes_where_it_is_told_and_refuses_nothing_at_all():
    ax = plot_scene(scene()).axes[0]
    assert plot_scene(SCENES, ax=ax, title="Here") is ax and ax.get_title() == "Here"
    with pytest.raises(ValueError, match="one scene or several"):
        plot_scene([])


def test_the_same_film_gives_the_same_small_gif(tmp_path):
    gif = FILM.gif(tmp_path / "film.gif")
    assert gif == FILM.gif() == (tmp_path / "film.gif").read_bytes()
    assert [file.name for file in tmp_path.iterdir()] == ["film.gif"]
    picture = Image.open(io.BytesIO(gif))
    assert (picture.n_frames, picture.size) == (20, (360, 360))
    assert picture.info["loop"] == 0 and picture.info["duration"] == 150
    assert len(gif) < 20 * 3000


def test_a_film_shows_itself_as_a_gif_with_a_description():
    data = FILM._repr_mimebundle_()
    alt, mime, file = shown(data)
    assert mime == "image/gif" and file[:6] == b"GIF89a"
    assert data["text/plain"] == "<Film of 20 steps>" and "20 steps" in alt


def test_a_world_without_a_robot_cannot_be_filmed():
    env = gymnasium.make("FrozenLake-v1")
    with pytest.raises(ValueError, match="no robot to film"):
        film(rl.Agent(env), env)


def test_a_still_page_works_offline_and_holds_the_scene():
    page = show_scene(scene()).html
    # the one address in it is a name that browsers know and do not fetch
    assert set(re.findall(r"https?://[^\"'\s)]+", page)) <= {"http://www.w3.org/1999/xhtml"}
    assert not re.search(r"<(script|link|img)[^>]+(src|href)", page)
    feed = feed_of(page)
    assert [solid["name"] for solid in feed["room"]["solids"]] == [solid.name for solid in scene().solids]
    (frame,) = feed["frames"]
    assert frame["places"]["robot/body"][3::4] == [0.5, 0, 0.13] and "wall/north" not in frame["places"]


def test_a_page_is_the_same_each_time_and_so_is_its_text(tmp_path):
    view = show_scene(SCENES, FILM.rewards)
    assert view.html == show_scene(SCENES, FILM.rewards).html
    assert repr(view) == repr(show_scene(SCENES)) and "20 steps" in repr(view)
    view.save(tmp_path / "room.html")
    assert (tmp_path / "room.html").read_text(encoding="utf-8") == view.html
    data = view._repr_mimebundle_()
    assert sum(len(str(value)) for value in data.values()) < 50_000 and data["text/plain"] == view.text
    assert shown(data)[0] == view.text


def test_a_replay_tells_where_the_robot_and_its_beams_are_in_every_scene():
    frames = feed_of(show_scene(SCENES, FILM.rewards).html)["frames"]
    assert [frame["reward"] for frame in frames] == FILM.rewards
    for frame, each in zip(frames, SCENES, strict=True):
        assert np.allclose(np.reshape(frame["places"]["robot/body"], (3, 4)), each.solids[4].pose[:3], atol=1e-5)
        assert np.allclose(frame["beams"], each.beams, atol=1e-5)
    with pytest.raises(ValueError, match="3 rewards for 20 scenes"):
        show_scene(SCENES, FILM.rewards[:3])


def news_of(live: LiveView, count: int = 0) -> tuple[dict, int]:
    """What a page is told that has seen `count` frames, and how many there have been."""
    news = live.so_far(count)
    return news, news["count"]


def test_a_browser_that_comes_late_gets_the_room_and_then_what_moves():
    live = LiveView()
    live.update(scene())
    news, count = news_of(live)
    assert len(news["room"]["solids"]) == 6 and len(news["frames"][0]["beams"]) == 3
    live.update(scene(0.5), reward=2.0, seconds=0.1)
    news, count = news_of(live, count)
    (frame,) = news["frames"]
    assert news["room"] is None and "wall/north" not in frame["places"]
    assert (frame["step"], frame["reward"], frame["seconds"]) == (1, 2.0, 0.1)
    assert math.isclose(frame["places"]["robot/body"][3], 0.5 * math.cos(0.5), abs_tol=1e-5)
    late, _ = news_of(live)
    assert late["room"] is not None and [frame["step"] for frame in late["frames"]] == [0, 1]
    assert news_of(live, count)[0]["frames"] == []


def test_a_notebook_is_sent_what_is_new_in_few_messages_and_all_of_it():
    live = LiveView()
    live.update(scene())
    sent = []
    live.widget.send = sent.append
    assert live.widget.news["room"] and len(live.widget.news["frames"]) == 1
    for i in range(200):
        live.update(scene(0.01 * i), reward=1.0)
    live._carry(at_once=True)
    steps = [frame["step"] for news in sent for frame in news["frames"]]
    assert steps == list(range(1, 201)), "each frame once, in their order"
    live.update(scene()._replace(solids=scene().solids[1:]), reward=1.0)
    live._carry(at_once=True)
    assert sent[-1]["room"] is not None or sent[-2]["room"] is not None
    live.close()
    assert sent[-1]["closed"]


def test_a_carried_view_shows_what_came_before_it_and_what_comes_after(browser):
    live, page, errors = LiveView(), browser.new_page(), []
    page.on("pageerror", lambda error: errors.append(str(error)))
    live.update(scene())
    told = {"page": live.widget.page, "news": live.widget.news}
    page.set_content("<main></main>")
    page.add_script_tag(content=live.widget._esm.replace("export default", "window.carried ="))
    page.evaluate(
        """told => {
            window.hears = new Set();
            const on = (_, hear) => hears.add(hear), off = (_, hear) => hears.delete(hear);
            const model = { get: (name) => told[name], on, off };
            carried.initialize({ model });
            window.show = () => carried.render({ model, el: document.querySelector('main') });
            window.hide = show();
        }""",
        told,
    )
    until(page, "frames.length === 1")
    until(page.frames[1], "typeof world === 'object' && frames.length === 1")
    sent = []
    live.widget.send = sent.append
    for i in range(3):
        live.update(scene(0.1 * i), reward=1.0)
    live._carry(at_once=True)
    arrive = "sent => sent.forEach((news) => hears.forEach((hear) => hear(news)))"
    page.evaluate(arrive, sent)
    until(page.frames[1], "frames.length === 4")
    live.close()
    page.evaluate(arrive, sent[-1:])
    until(page.frames[1], "caption.textContent === 'The live view has ended.'")
    page.close()
    assert errors == []


def test_a_live_view_keeps_the_last_frames_for_whom_comes_late():
    live = LiveView()
    for i in range(KEPT + 10):
        live.update(scene(0.01 * i), reward=1.0)
    assert [frame["step"] for frame in news_of(live)[0]["frames"]] == list(range(11, KEPT + 11))


def test_another_room_takes_the_place_of_the_old_one():
    live = LiveView()
    live.update(scene(), reward=1.0)
    count = news_of(live)[1]
    live.update(scene()._replace(solids=scene().solids[1:]), reward=1.0)
    for seen in (0, count):
        news, _ = news_of(live, seen)
        assert [solid["name"] for solid in news["room"]["solids"]][:2] == ["wall/west", "goal"]
        assert [frame["step"] for frame in news["frames"]] == [1]


def history(method: str, seed: int, steps: int = 50) -> History:
    """A process of random rewards in which nothing was learned."""
    return history_of(np.random.default_rng(seed).normal(size=steps), method)


def history_of(rewards: np.ndarray, method: str = "Q+SR") -> History:
    transitions = Transitions.empty(len(rewards))._replace(r=rewards)
    nothing = Learned.of(np.zeros((1, 1)), np.zeros((1, 1), dtype=int))
    return History(method, transitions.without_states(), nothing, 0.0, Size((1,), 1))


def test_curves_are_named_and_differ_by_more_than_their_colour():
    repetitions = [history("TOSL+SR", seed) for seed in range(5)]
    figure = plot_learning(history("Q+SR", 9), repetitions)
    (ax,), (legend,) = figure.axes, figure.legends
    assert [line.get_linestyle() for line in ax.lines] == ["-", "--"]
    assert [text.get_text() for text in legend.get_texts()] == ["Q+SR", "TOSL+SR (5 repetitions)"]
    assert "95 %" in legend.get_title().get_text()
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("step", "average reward per step")
    assert len(ax.collections) == 1
    assert np.allclose(ax.lines[1].get_ydata(), np.mean([h.average_reward for h in repetitions], axis=0))


def test_a_live_view_follows_an_agent_that_learns_as_it_does_alone(monkeypatch):
    monkeypatch.delenv("RLROBOT_EDU_PROGRESS", raising=False)
    env = rl.make_env("wander_simple", seed=0)
    live = LiveView()
    start = time.monotonic()
    film_ = live.follow(rl.Agent("wander_simple", seed=0), env, steps=150, speed=1000)
    assert time.monotonic() - start > 0.149
    frames = news_of(live)[0]["frames"]
    alone = list(rl.steps(rl.Agent("wander_simple", seed=0), rl.make_env("wander_simple", seed=0), steps=150))
    rewards = [step.r for step in alone]
    assert [frame["reward"] for frame in frames] == rewards and frames[0]["seconds"] == 1e-3
    assert film_.rewards == rewards[-100:] and film_.gif()[:6] == b"GIF89a"


def test_a_live_view_is_slowed_down_for_nobody(monkeypatch):
    monkeypatch.setenv("RLROBOT_EDU_PROGRESS", "0")
    env = rl.make_env("wander_simple", seed=0)
    start = time.monotonic()
    live = LiveView()
    live.follow(rl.Agent("wander_simple", seed=0), env, steps=100, speed=1)
    assert news_of(live)[0]["frames"][0]["seconds"] == 1
    assert time.monotonic() - start < 99


def test_a_live_view_refuses_a_world_without_a_robot_and_no_speed_at_all():
    env = rl.make_env("wander_simple", seed=0)
    live = LiveView()
    for speed in (0, -1, math.nan):
        with pytest.raises(ValueError, match="speed must be above 0"):
            live.follow(rl.Agent("wander_simple"), env, steps=5, speed=speed)
    with pytest.raises(ValueError, match="no robot to film"):
        live.follow(rl.Agent("wander_simple"), gymnasium.make("FrozenLake-v1"), steps=5, speed=1)


def test_a_figure_says_in_words_what_it_shows():
    alt, mime, file = shown(plot_learning(history("Q+SR", 9))._repr_mimebundle_())
    assert mime == "image/png" and "Q+SR ends at" in alt
    assert Image.open(io.BytesIO(file)).size == (2 * 585, 2 * 378), "twice as fine as it is shown"


def test_signs_in_an_alt_text_are_no_html():
    picture = Picture(alt='Q < 0 & "so on"')
    assert html.unescape(picture.still().html.split('"')[1]) == picture.alt


def test_no_letters_of_a_figure_are_too_small():
    picture = Picture((2, 2))
    picture.subplots().set_title("small", fontsize=5)
    picture.text(0, 0, "large", fontsize=20)
    picture.png()
    assert {text.get_fontsize() for text in picture.findobj(Text)} >= {8.5, 20}
    assert min(text.get_fontsize() for text in picture.findobj(Text)) == 8.5


def test_the_leap_at_the_start_does_not_squeeze_the_rest_of_a_curve():
    ax = Figure().subplots()
    rewards = np.full(1000, 1.0)
    rewards[0], rewards[500:] = 100.0, 2.0
    plot_learning(history_of(rewards), ax=ax)
    low, high = ax.get_ylim()
    assert 0 < low < 1.2 and 2 < high < 7, "from step 20 on: 100 at the start is off the picture"
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


@in_a_thread
def test_while_a_slider_is_dragged_there_is_a_draft_and_then_the_fine_picture(wander_model):
    sliders = ParameterSliders(wander_model, steps=300, repetitions=2)

    async def drag() -> tuple[str, str]:
        for value in (2.0, 3.0):
            sliders.sliders["temperature"].value = value
        draft = sliders.widget.children[-1].value
        await asyncio.sleep(REST + 0.1)
        return draft, sliders.widget.children[-1].value

    draft, fine = asyncio.run(drag())
    assert "temperature 3" in draft and "temperature 3" in fine and len(draft) != len(fine)
    assert fine == sliders._repr_mimebundle_()["text/html"]
    sizes = [Image.open(io.BytesIO(shown({"text/html": page})[2])).width for page in (draft, fine)]
    assert sizes[0] < sizes[1] == 1170


def test_sliders_are_those_that_were_asked_for(wander_model):
    sliders = ParameterSliders(wander_model, "Q+SR", ["alpha"], steps=300, repetitions=2)
    assert list(sliders.sliders) == ["alpha"]
    assert "1 slider, α" in sliders._repr_mimebundle_()["text/plain"]
    for parameters in (["beta"], [], "alpha"):
        with pytest.raises(ValueError, match="some of alpha, gamma, lam, temperature"):
            ParameterSliders(wander_model, "Q+SR", parameters)


def test_curves_that_cannot_be_drawn_are_refused_in_words():
    with pytest.raises(ValueError, match="empty"):
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
for wish in (film.show3d, lambda: rl.show_scene(film.frames), lambda: rl.watch(agent, env, steps=2)):
    try:
        wish()
    except ImportError as error:
        print(error)
"""


def test_without_meshcat_all_but_3d_works_and_3d_says_what_to_install():
    run = subprocess.run([sys.executable, "-c", WITHOUT_MESHCAT], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert run.stdout.splitlines() == 3 * [
        "3D views need meshcat: run pip install 'rlrobot-edu[view3d]'; everything else works without it"
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
    until(page, "document.getElementById('caption').textContent.startsWith('step 3 of 20: reward')")
    page.click("#play")
    page.evaluate("time.value = 3; time.oninput()")
    until(page, "shown.step === 3 && !moved")
    first, trail = seen(page), page.evaluate("trail.geometry.drawRange.count")
    page.evaluate("time.value = 16; time.oninput()")
    until(page, "caption.textContent === 'step 16 of 20: reward −2 · mean of the last 16: +5.5' && !moved")
    assert seen(page).tobytes() != first.tobytes()
    assert page.evaluate("trail.geometry.drawRange.count") > trail  # it grows with the way


def test_a_page_without_rewards_tells_the_steps_alone(opened):
    page = opened(show_scene(SCENES))
    page.evaluate("time.value = 16; time.oninput()")
    until(page, "caption.textContent === 'step 16 of 20' && chart.hidden")


BEAMS = "at = 2.5; playing = false; show(); beams.map(({hit: {position: p}}) => [p.x, p.y])"


def test_beams_end_at_walls_between_two_scenes_as_well(opened):
    film_ = film(rl.Agent("wander_simple", seed=0), rl.make_env("wander_simple", seed=0), steps=5)
    page = opened(film_.show3d())
    until(page, "typeof frames === 'object' && frames.length === 5")
    ends = np.array(page.evaluate(BEAMS))
    assert ends.shape == (8, 2) and np.allclose(np.abs(ends).max(axis=1), 1.0, atol=1e-3)


INSIDE = """Object.values(robot).every(part => {
  const box = new T.Box3().setFromObject(part);
  return [box.min, box.max].every(p => { p.project(camera); return Math.abs(p.x) < 1 && Math.abs(p.y) < 1; });
})"""


@pytest.mark.parametrize("task", ["wander_1k", "giraff_wander_1k", "navigation_1k", "arm_1k", "mobile_arm_2k"])
def test_the_whole_robot_is_in_the_picture(opened, task):
    if "arm" in task:
        pytest.importorskip("pybullet")
    page = opened(show_scene(rl.make_env(task, seed=0).unwrapped.robot.scene()), 600, 400)
    until(page, "typeof scene === 'object' && camera.aspect > 1")
    assert page.evaluate(INSIDE)


def test_a_hull_in_3d_is_closed_and_shows_its_outer_sides(opened):
    page = opened(show_scene(scene()))
    base, height = np.array(PIONEER.hull), 0.16
    numbers = page.evaluate(f"Array.from(prism({base.tolist()}, {height}).toNonIndexed().attributes.position.array)")
    one, two, three = np.reshape(numbers, (-1, 3, 3)).swapaxes(0, 1)
    area = np.sum(base[:, 0] * np.roll(base[:, 1], -1) - np.roll(base[:, 0], -1) * base[:, 1]) / 2
    assert np.sum(one * np.cross(two, three)) / 6 == pytest.approx(area * height, rel=1e-5)  # the divergence theorem
    assert np.cross(two - one, three - one).sum(axis=0) == pytest.approx(np.zeros(3), abs=1e-6)


def test_the_wheel_zooms_only_after_a_click_and_the_chase_camera_follows_the_robot(opened):
    distance = "camera.position.distanceTo(controls.target)"
    page = opened(show_scene(SCENES, FILM.rewards), 500, 300)
    until(page, "frames.length === 20 && !bar.hidden && view.clientHeight === renderer.domElement.clientHeight")
    whole = page.evaluate(distance)
    page.mouse.move(100, 150)
    page.mouse.wheel(0, 300)
    until(page, "!hint.hidden")
    assert page.evaluate(distance) == pytest.approx(whole)
    page.mouse.click(100, 150)
    page.mouse.wheel(0, 300)
    until(page, f"Math.abs({distance} - {whole}) > 0.01 && hint.hidden")
    page.click("#chase")
    page.evaluate("time.value = 11; time.oninput()")
    until(page, "controls.target.distanceTo(robot['robot/body'].position) < 1e-6 && !moved")
    assert page.evaluate(distance) < 0.8 * whole
    page.click("#chase")
    until(page, f"Math.abs({distance} - {whole}) < 1e-6")


def test_a_film_tells_what_is_noted_of_a_step_besides_its_reward():
    assert Film(SCENES[:2], [10, -2], notes=["T = 1", "T = 6.25"])._captions()[1] == "step 2 of 2: reward -2, T = 6.25"
    assert Film(SCENES[:1], [0.5])._captions() == ["step 1 of 1: reward +0.5"]
    noted = dataclasses.replace(FILM, notes=[f"T = {i}" for i in range(20)])
    assert noted.gif() != FILM.gif()
    with pytest.raises(ValueError, match="argument 2 is shorter"):
        dataclasses.replace(FILM, notes=["T = 1"]).gif()
