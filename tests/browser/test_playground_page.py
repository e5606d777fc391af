"""The playground in a browser: it learns at once, what is changed there changes what is learned, and all can use it."""

from __future__ import annotations

import numpy as np
import pytest
from waiting import until

import rlrobot_edu as rl

PAUSED = "&speed=0.1"
LIVE = """(steps) => { play(false); begin(); while (life.t < steps) life.step();
    return life.m.q.map((row) => Array.from(row)); }"""


@pytest.fixture
def opened(browser, tmp_path):
    """Opens the page; it must ask for nothing but itself, and say nothing on the console."""
    pages, faults, asked = [], [], set()
    rl.playground(tmp_path / "page.html")

    def opened(link="", **settings):
        page = browser.new_page(**{"viewport": {"width": 1280, "height": 800}} | settings)
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
    agent, env = rl.Agent(task, method, seed=0, **parameters), rl.make_env(task, seed=0, engine="kinematic")
    rl.learn(agent, env, steps=steps, progress=False)
    return agent.q


def at(page, x: float, y: float) -> tuple[float, float]:
    """Where on the page a point of the floor is [m]."""
    box, (left, top) = page.locator("#picture").bounding_box(), page.evaluate(f"view.at({x}, {y})")
    return box["x"] + left, box["y"] + top


def test_it_learns_at_once_and_after_10000_steps_its_q_is_the_librarys_to_the_last_bit(opened):
    page = opened()
    until(page, "life.t > 100 && find('update').textContent.includes('δ')")
    np.testing.assert_array_equal(page.evaluate(LIVE, 10_000), learned("wander_1k", "TOSL+QBIASSR", 10_000))


def test_a_slider_starts_again_with_the_same_luck_and_the_run_before_stays_as_a_ghost(opened):
    page = opened("#task=wander_simple&method=SARSA%2BSR")
    until(page, "life.t > 100")
    page.get_by_role("slider", name="α").press("End")
    until(page, "before !== null && find('mean').textContent.includes('the run before, with α 0.1')")
    q = learned("wander_simple", "SARSA+SR", 500, alpha=1.0)
    np.testing.assert_array_equal(page.evaluate(LIVE, 500), q)
    assert "alpha=1&" in page.get_by_role("link", name="Link to this").get_attribute("href")
    assert page.get_by_role("slider").count() == 3, "λ and ε are nothing to SARSA+SR"


def test_a_link_holds_all_settings_and_a_wrong_one_harms_nothing(opened):
    page = opened("#task=navigation_1k&method=SL%2BSR&alpha=0.5&lam=0.3&luck=7&speed=100")
    assert page.locator("#method").input_value() == "SL+SR" and page.locator("#luck").input_value() == "7"
    link = page.get_by_role("link", name="Link to this").get_attribute("href")
    again = opened(link)
    assert again.evaluate("settings") == page.evaluate("settings")
    wrong = opened("#task=__proto__&method=none&alpha=7&luck=-1&speed=x&walls=1:2,3;x;99:0,0,0,0,0,0")
    until(wrong, "life.t > 10 && settings.task === 'wander_1k' && settings.alpha === 0.1")


def test_a_wall_is_dragged_by_a_mouse_and_moved_by_keys(opened):
    page = opened("#task=wander_1k" + PAUSED)
    until(page, "view !== null")
    before = page.evaluate("inside().map((wall) => Array.from(wall))")
    wall = next(i for i, each in enumerate(before) if each[:2] == [-0.875, -0.9])
    page.mouse.move(*at(page, -0.875, -0.9))
    page.mouse.down()
    page.mouse.move(*at(page, -1.5, -0.4), steps=4)
    page.mouse.up()
    now = page.evaluate(f"Array.from(inside()[{wall}])")
    assert now[:2] == pytest.approx([-1.5, -0.4], abs=0.02) and now[2:] == before[wall][2:]
    assert f"walls={wall}:" in page.url
    page.locator("#picture").focus()
    page.keyboard.press("ArrowUp")
    page.keyboard.press("r")
    turned = page.evaluate(f"Array.from(inside()[{wall}])")
    assert turned[1] == pytest.approx(now[1] + 0.05) and turned[4] != now[4]
    again = opened("#" + page.url.partition("#")[2])
    assert again.evaluate(f"Array.from(inside()[{wall}])") == pytest.approx(turned, abs=1e-3)


def test_pointing_at_the_floor_tells_the_row_of_the_state_there(opened):
    page = opened("#task=navigation_1k" + PAUSED)
    until(page, "view !== null")
    page.get_by_role("button", name="Pause").click()
    page.mouse.move(*at(page, 1.5, -1.5))
    until(page, "find('where').textContent.includes('where you point') && pointed !== null")
    env = rl.make_env("navigation_1k", engine="kinematic")
    _, info = env.reset()
    there = info["readings"] | {"x": 1.5 - 0.045, "y": -1.5}
    state, expected = page.evaluate("pointed"), env.unwrapped.task.states.encode(there)
    assert env.unwrapped.task.states.bins(state)[:2] == env.unwrapped.task.states.bins(expected)[:2]
    assert page.locator("#actions tbody tr").count() == env.action_space.n


@pytest.mark.parametrize(("scheme", "width"), [("light", 1920), ("light", 1280), ("dark", 390)])
def test_all_can_use_it(opened, scheme, width):
    axe = pytest.importorskip("axe_playwright_python.sync_playwright", reason="needs axe-playwright-python").Axe()
    for task in ("wander_1k", "cliff", "worked_example"):
        page = opened(f"#task={task}", color_scheme=scheme, viewport={"width": width, "height": 844})
        until(page, "life.t > 10 && (picture.ariaLabel || '').length > 10")
        found = axe.run(page, options={"resultTypes": ["violations"]})
        serious = [each for each in found.response["violations"] if each["impact"] in ("serious", "critical")]
        assert not serious, [(each["id"], [node["html"][:200] for node in each["nodes"]][:3]) for each in serious]
        assert page.evaluate("document.documentElement.scrollWidth") == width
        small = "[...document.querySelectorAll('button, select, input')].filter((e) => e.offsetHeight < 28).length"
        assert page.evaluate(small) == 0


def test_for_who_wants_no_motion_it_stands_still_after_an_hour_of_its_life(opened):
    page = opened(reduced_motion="reduce")
    until(page, "life.t >= 3600 && find('play').textContent === 'Play'")
    t = page.evaluate("life.t")
    page.wait_for_timeout(300)
    assert page.evaluate("life.t") == t
    page.get_by_role("button", name="Play").press("Space")
    until(page, f"life.t > {t}")
