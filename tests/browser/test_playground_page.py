"""The playground in a browser: it learns at once, what is changed there changes what is learned, and all can use it."""

from __future__ import annotations

import numpy as np
import pytest
from waiting import until

import rlrobot_edu as rl

PAUSED = "&speed=0.1"
Q = "yours.simulation.m.q.map((row) => Array.from(row))"
LIVE = f"(steps) => {{ play(false); begin(); while (yours.simulation.t < steps) yours.step(); return {Q}; }}"


@pytest.fixture
def opened(browser, tmp_path):
    """Opens the page; it must ask for nothing but itself, and say nothing on the console."""
    pages, faults, asked = [], [], set()
    rl.playground(tmp_path / "page.html")

    def opened(link="", **settings):
        page = browser.new_page(
            **{"viewport": {"width": 1280, "height": 800}} | settings
        )
        pages.append(page)
        page.on("pageerror", lambda error: faults.append(str(error)))
        page.on("console", lambda said: faults.append(said.text))
        page.on("request", lambda request: asked.add(request.url.split("#")[0]))
        page.goto((tmp_path / "page.html").as_uri() + link)
        return page

    yield opened
    for page in pages:
        page.close()
    assert faults == [] and asked == {(tmp_path / "page.html").as_uri()}


def learned(task: str, method: str, steps: int, **parameters) -> np.ndarray:
    agent, env = (
        rl.Agent(task, method, seed=0, **parameters),
        rl.make_env(task, seed=0, engine="kinematic"),
    )
    rl.learn(agent, env, steps=steps, progress=False)
    return agent.q


def at(page, x: float, y: float) -> tuple[float, float]:
    """Where on the page a point of the floor is [m]."""
    box, (left, top) = (
        page.locator("#picture").bounding_box(),
        page.evaluate(f"view.at({x}, {y})"),
    )
    return box["x"] + left, box["y"] + top


def drag(page, start, end) -> None:
    page.mouse.move(*at(page, *start))
    page.mouse.down()
    page.mouse.move(*at(page, *end), steps=8)
    page.mouse.up()


def test_it_learns_at_once_and_after_10000_steps_its_q_is_the_librarys_to_the_last_bit(
    opened,
):
    page = opened()
    until(page, "yours.simulation.t > 10 && find('update').textContent.includes('δ')")
    np.testing.assert_array_equal(
        page.evaluate(LIVE, 10_000), learned("wander_1k", "TOSL+QBIASSR", 10_000)
    )


def test_a_slider_starts_again_with_the_same_luck_and_the_run_before_stays_as_a_ghost(
    opened,
):
    page = opened("#task=navigation_1k&method=SARSA%2BSR&speed=10")
    until(page, "yours.curve.steps > 0")
    page.get_by_role("slider", name="α").press("End")
    until(
        page,
        "before !== null && find('mean').textContent.includes('the run before, with α 0.1')",
    )
    q = learned("navigation_1k", "SARSA+SR", 500, alpha=1.0)
    np.testing.assert_array_equal(page.evaluate(LIVE, 500), q)
    assert "alpha=1&" in page.url
    assert page.get_by_role("slider").count() == 3, "λ and ε are nothing to SARSA+SR"


def test_a_link_holds_all_settings_and_a_wrong_one_harms_nothing(opened):
    page = opened(
        "#task=navigation_1k&method=SL%2BSR&alpha=0.5&lam=0.3&luck=7&speed=100"
    )
    assert (
        page.locator("#method").input_value() == "SL+SR"
        and page.locator("#luck").input_value() == "7"
    )
    again = opened("#" + page.url.partition("#")[2])
    assert again.evaluate("settings") == page.evaluate("settings")
    wrong = opened(
        "#task=__proto__&method=none&alpha=7&luck=-1&speed=x&walls=1:2,3;x;0,0,1,0;9,9,9,9"
    )
    until(
        wrong,
        "yours.simulation.t > 10 && settings.task === 'wander_1k' && settings.alpha === 0.1",
    )
    assert wrong.evaluate("walls") == [], (
        "one would stand on the robot, the others are no walls"
    )


def test_the_button_that_copies_the_link_says_so(opened):
    page = opened("#task=cliff")
    page.get_by_role("button", name="Copy link").click()
    page.get_by_role("button", name="Copied").wait_for()
    page.get_by_role("button", name="Copy link").wait_for()  # for the next time


def test_a_wall_is_dragged_by_a_mouse_and_moved_by_keys(opened):
    page = opened("#task=wander_1k" + PAUSED)
    until(page, "view !== null")
    before = page.evaluate("inside()")
    wall = next(i for i, each in enumerate(before) if each[:2] == [-0.875, -0.9])
    drag(page, (-0.875, -0.9), (-1.5, -0.4))
    now = page.evaluate(f"inside()[{wall}]")
    assert (
        now[:2] == pytest.approx([-1.5, -0.4], abs=0.02) and now[2:] == before[wall][2:]
    )
    page.locator("#picture").focus()
    page.keyboard.press("ArrowUp")
    page.keyboard.press("r")
    turned = page.evaluate(f"inside()[{wall}]")
    assert turned[1] == pytest.approx(now[1] + 0.05) and turned[3] == now[3] + 15
    again = opened("#" + page.url.partition("#")[2])
    assert again.evaluate("inside()") == page.evaluate("inside()")
    rows = "Array.from(yours.world.walls, (wall) => Array.from(wall))"
    assert again.evaluate(rows) == page.evaluate(rows), (
        "to the last bit: so the link leads to the same life"
    )


def test_walls_stay_in_the_room_and_off_the_robot_and_can_be_drawn_taken_away_and_put_back(
    opened,
):
    page = opened("#task=wander_1k" + PAUSED)
    until(page, "view !== null")
    page.get_by_role("button", name="Pause").click()
    page.evaluate("begin()")  # the robot stands at its start
    until(page, "view !== null")
    n = page.evaluate("inside().length")
    drag(page, (-0.875, -0.9), (-7, -0.9))
    assert min(x for x, *_ in page.evaluate("inside()")) == -2.85, (
        "half its thickness from the wall of the room"
    )
    drag(page, (-2.85, -0.9), (0, 0))
    robot = page.evaluate("[yours.here[0], yours.here[1]]")
    assert (
        page.evaluate(
            "Math.min(...inside().map((wall) => distanceTo(wall, ...yours.here)))"
        )
        > 0.3
    ), robot
    page.get_by_role("button", name="Draw a wall").click()
    drag(page, (-2.0, 0.5), (-2.0, 1.3))
    assert page.evaluate("inside().at(-1)") == pytest.approx(
        [-2.0, 0.9, 0.4, 90], abs=0.05
    )
    assert page.evaluate("yours.world.walls.length") == n + 5
    page.get_by_role("button", name="Turn").click()
    assert page.evaluate("inside().at(-1)[3]") == pytest.approx(120, abs=3)
    page.get_by_role("button", name="Take away").click()
    assert page.evaluate("inside().length") == n
    page.get_by_role("button", name="Put the walls back").click()
    assert page.evaluate("inside()") == page.evaluate(
        "wallsInside(newSimulation(settings).world)"
    )
    assert "walls=" not in page.url


def test_the_robot_is_set_elsewhere_by_hand_but_not_into_a_wall(opened):
    page = opened("#task=wander_1k" + PAUSED)
    until(page, "view !== null")
    page.get_by_role("button", name="Pause").click()
    drag(page, page.evaluate("yours.here.slice(0, 2)"), (0.0, -1.2))
    there = page.evaluate("yours.here")
    assert there[:2] == pytest.approx([0, -1.2], abs=0.03)
    assert page.evaluate(
        "yours.simulation.pending[0] === yours.world.stateOf(yours.world.sense(yours.here))"
    )
    drag(page, (0.0, -1.2), (-0.025, -2.4))
    assert page.evaluate("isFree(yours.world, yours.here, inside())")


@pytest.mark.parametrize(
    ("name", "steps"), [("after an hour", 3_600), ("after a day", 86_400)]
)
def test_a_button_leads_to_a_stage_of_its_life_with_the_numbers_of_its_single_steps(
    opened, name, steps
):
    page = opened("#task=wander_1k&method=TOSL%2BSR" + PAUSED)
    arrived = f"yours.simulation.t >= {steps}"  # seen in the same frame
    look = f"function look() {{ if ({arrived}) leapt = [yours.simulation.t, {Q}]; else requestAnimationFrame(look); }}"
    page.evaluate("begin()")
    page.evaluate(f"window.leapt = null; requestAnimationFrame({look})")
    page.get_by_role("button", name=name).click()
    until(page, "leapt !== null")
    t, q = page.evaluate("leapt")
    assert t == steps
    np.testing.assert_array_equal(q, page.evaluate(LIVE, steps))
    page.get_by_role("button", name="a beginner").click()
    until(page, "yours.simulation.t < 100 && find('last').textContent === '?'")


def test_two_robots_race_with_the_same_luck_and_never_with_the_same_method(opened):
    page = opened("#task=wander_1k&alpha=0.5" + PAUSED)
    until(page, "yours.simulation.t >= 3600")
    rivals = page.locator("#race option").all_inner_texts()
    assert rivals == [
        "nobody",
        "chance",
        "Q-learning",
        "the paper’s method without its bias",
    ]
    page.get_by_label("Race against").select_option(
        "the paper’s method without its bias"
    )
    until(page, "rival !== null && rival.simulation.t === yours.simulation.t")
    page.get_by_text("The other robot, the paper’s method without its bias").wait_for()
    page.evaluate("play(false)")
    t, q = page.evaluate(
        "[rival.simulation.t, rival.simulation.m.q.map((row) => Array.from(row))]"
    )
    np.testing.assert_array_equal(q, learned("wander_1k", "TOSL+SR", t, alpha=0.5))
    page.locator("#method").select_option("TOSL+SR")
    until(page, "rival === null")
    assert "the paper’s method" in page.locator("#race option").all_inner_texts()
    assert "without" not in " ".join(page.locator("#race option").all_inner_texts())


def test_it_opens_at_the_age_at_which_learning_shows_and_plays_on(opened):
    for task, age in (("wander_1k", 3600), ("navigation_1k", 14_400), ("cliff", 3600)):
        page = opened(f"#task={task}")
        until(page, "find('last').textContent.length > 0")
        first, last = (
            int(page.locator(f"#{name}").inner_text()) for name in ("first", "last")
        )
        assert last >= 2 * first + 2 if task == "navigation_1k" else 2 * last <= first
        until(page, f"yours.simulation.t > {age} && playing")


@pytest.mark.parametrize("task", ["wander_1k", "navigation_1k", "cliff"])
def test_a_telephones_first_screen_has_the_robot_then_play_then_the_score(opened, task):
    page = opened(f"#task={task}", viewport={"width": 390, "height": 844})
    until(page, "view !== null")
    assert page.locator("#picture").bounding_box()["y"] < 160
    play = page.locator("#play").bounding_box()
    box = page.locator("#numbers").bounding_box()
    assert play["y"] < box["y"]
    assert box["y"] + box["height"] < 844


def test_the_first_things_that_tab_reaches_are_pause_speed_and_age(opened):
    page = opened()
    until(page, "yours.simulation.t > 10")
    reached = []
    for _ in range(6):
        page.keyboard.press("Tab")
        reached.append(
            page.evaluate(
                "document.activeElement.id || document.activeElement.textContent"
            )
        )
    assert reached == [
        "play",
        "again",
        "speed",
        "a beginner",
        "after an hour",
        "after a day",
    ]


def test_bars_of_values_have_one_scale_and_there_is_none_beside_a_zero(opened):
    page = opened("#task=wander_1k" + PAUSED)
    until(page, "yours.simulation.t >= 3600")
    # in one go: a frame that is drawn in between would show another row
    most, q, widths, first = page.evaluate(
        """() => {
            play(false);
            const { q } = yours.simulation.m;
            const most = Math.max(...q.flatMap((row) => Array.from(row, Math.abs)));
            const s = q.findIndex((row) => row.some((x) => x > 1));
            q[s][0] = 0;
            showRow(s);
            const bars = Array.from(document.querySelectorAll(".bar"));
            const first = document.querySelector("#actions tbody tr td:nth-of-type(3)");
            const widths = bars.map((bar) => parseFloat(bar.style.width));
            return [most, Array.from(q[s]), widths, first.innerText];
        }"""
    )
    assert widths == pytest.approx([100 * abs(x) / most for x in q], abs=0.01)
    assert widths[0] == 0
    assert first == "0.00"


def test_a_finger_sees_what_the_robot_would_do_and_moves_a_wall(opened):
    page = opened(
        "#task=wander_1k" + PAUSED,
        has_touch=True,
        viewport={"width": 390, "height": 844},
    )
    until(page, "view !== null")
    page.touchscreen.tap(*at(page, 2.3, 1.0))
    page.locator("#tip").wait_for()
    page.touchscreen.tap(*at(page, -0.875, -0.9))
    degrees = page.evaluate("inside()[chosen][3]")
    page.get_by_role("button", name="Turn").tap()
    assert page.evaluate("inside()[chosen][3]") == (degrees + 30) % 180


def test_the_page_around_gets_the_height_of_the_page_and_gives_it_its_colours(browser):
    """As a notebook shows it: in a frame that may do nothing but run scripts."""
    page = browser.new_page(
        viewport={"width": 900, "height": 700}, color_scheme="light"
    )
    try:
        widget = rl.playground(task="wander_1k").widget
        page.set_content(
            "<body style='background: rgb(17, 18, 19)'><div id='el'></div></body>"
        )
        script = widget._esm.replace("export default", "const shown =")
        page.add_script_tag(content=f"{script}; window.shown = shown;")
        page.evaluate(
            "(told) => { shown.render({ model: { get: (name) => told[name] }, el: document.getElementById('el') }); }",
            {"page": widget.page, "title": widget.title},
        )
        page.frame_locator("iframe").get_by_text("Nobody tells this robot").wait_for()
        frame = page.frames[1]
        until(frame, "document.documentElement.dataset.theme === 'dark'")
        assert (
            frame.evaluate("getComputedStyle(document.body).backgroundColor")
            == "rgb(17, 18, 19)"
        )
        fits = (
            "Math.abs(innerHeight - document.body.getBoundingClientRect().height) <= 1"
        )
        until(frame, fits)
        page.evaluate("document.body.style.background = 'white'")
        until(frame, "document.documentElement.dataset.theme === 'light'")
        page.set_viewport_size({"width": 420, "height": 700})
        until(frame, f"innerWidth < 420 && {fits}")
    finally:
        page.close()


def test_pointing_at_the_floor_tells_the_row_of_the_state_there(opened):
    page = opened("#task=navigation_1k" + PAUSED)
    until(page, "view !== null")
    page.get_by_role("button", name="Pause").click()
    page.mouse.move(*at(page, 1.5, -1.5))
    until(
        page,
        "find('where').textContent.includes('where you point') && pointed !== null",
    )
    env = rl.make_env("navigation_1k", engine="kinematic")
    _, info = env.reset()
    there = info["readings"] | {"x": 1.5 - 0.045, "y": -1.5}
    state, expected = page.evaluate("pointed"), env.unwrapped.task.states.encode(there)
    assert (
        env.unwrapped.task.states.bins(state)[:2]
        == env.unwrapped.task.states.bins(expected)[:2]
    )
    assert page.locator("#actions tbody tr").count() == env.action_space.n


@pytest.mark.parametrize(
    ("scheme", "width"), [("light", 1920), ("light", 1280), ("dark", 390)]
)
def test_all_can_use_it(opened, scheme, width):
    axe = pytest.importorskip(
        "axe_playwright_python.sync_playwright", reason="needs axe-playwright-python"
    ).Axe()
    for task in ("wander_1k", "cliff"):
        page = opened(
            f"#task={task}",
            color_scheme=scheme,
            viewport={"width": width, "height": 844},
        )
        until(page, "yours.simulation.t > 10 && (picture.ariaLabel || '').length > 10")
        found = axe.run(page, options={"resultTypes": ["violations"]})
        serious = [
            each
            for each in found.response["violations"]
            if each["impact"] in ("serious", "critical")
            or each["id"] == "empty-table-header"
        ]
        assert not serious, [
            (each["id"], [node["html"][:200] for node in each["nodes"]][:3])
            for each in serious
        ]
        assert page.evaluate("document.documentElement.scrollWidth") == width
        seen = "[...document.querySelectorAll('button, select, input')].filter((e) => e.offsetParent)"
        assert page.evaluate(f"{seen}.filter((e) => e.offsetHeight < 28).length") == 0


def test_for_who_wants_no_motion_it_stands_still_after_an_hour_of_its_life(opened):
    page = opened(reduced_motion="reduce")
    until(page, "yours.simulation.t >= 3600 && find('play').textContent === 'Play'")
    t = page.evaluate("yours.simulation.t")
    page.wait_for_timeout(300)
    assert page.evaluate("yours.simulation.t") == t
    page.get_by_role("button", name="Play").press("Space")
    until(page, f"yours.simulation.t > {t}")
