"""Pages without a kernel: what is in the file is what Python draws, and a browser needs nothing else."""

import base64
import io
import json
import re
import zlib
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image
from test_show import FILM, SCENES
from waiting import until

import rlrobot_edu as rl
from rlrobot_edu.show.film import Film
from rlrobot_edu.show.in3d.visualizer import show_scene
from rlrobot_edu.widgets.bias_explorer.explorer import BiasExplorer
from rlrobot_edu.widgets.bias_explorer.words import amount, finding, percents, vector

TABLES = {
    name: np.random.default_rng(seed).normal(scale=5, size=(24, 3))
    for seed, name in enumerate(("a <1>", "b"))
}


def stepper_of(
    task: str = "worked_example", method: str = "TOSL+QBIASSR", **options
) -> rl.Stepper:
    return rl.Stepper(
        rl.Agent(task, method, seed=0), rl.make_env(task, seed=0), **options
    )


def told_in(path) -> dict:
    """What a stepper's page is told, unpacked as the page unpacks it."""
    packed = re.search(
        r'<script id="packed" type="text/plain">(.*)</script>',
        path.read_text(encoding="utf-8"),
    )[1]
    told = json.loads(zlib.decompress(base64.b64decode(packed)))["feed"]
    columns = told["frames"].items()
    return told | {
        "frames": [
            {name: x[i] for name, x in columns} for i in range(len(told["frames"]["t"]))
        ]
    }


def test_a_page_begins_with_the_earliest_step_that_is_kept(tmp_path):
    path, stepper = tmp_path / "page.html", stepper_of(at=60, keep=20)
    stepper.back(5)
    stepper.save(path)
    told = told_in(path)
    assert stepper.t == 55 == told["at"] and [
        told["frames"][i]["t"] + 1 for i in (0, -1)
    ] == [41, 60]
    stepper.save(path, 90)
    assert stepper.t == 71, "the step shown has been dropped for newer ones"
    stepper.save(path, 75)
    assert [frame["t"] + 1 for frame in told_in(path)["frames"]] == [71, 72, 73, 74, 75]


def test_pages_are_small(tmp_path):
    sizes = {("worked_example", "Q+SR", 100): 55, ("worked_example", "TOSL+QBIASSR", 100): 75,
             ("wander_1k", "TOSL+QBIASSR", 200): 180}  # fmt: skip
    for (task, method, steps), kilobytes in sizes.items():
        stepper_of(task, method).save(tmp_path / "page.html", steps)
        assert (tmp_path / "page.html").stat().st_size < 1000 * kilobytes


def test_what_cannot_be_saved_is_said_and_the_old_page_stays(tmp_path, monkeypatch):
    page, stepper = tmp_path / "page.html", stepper_of(at=30, keep=10)
    stepper.save(page)
    old = page.read_bytes()
    with pytest.raises(ValueError, match="steps must be a whole number"):
        stepper.save(page, -1)
    earliest = "there is no step 20 to show: the earliest that is kept is 21"
    with pytest.raises(ValueError, match=earliest):
        stepper.save(page, 20)
    with pytest.raises(
        IsADirectoryError, match="this is a folder; give the name of a file"
    ):
        stepper.save(tmp_path)
    with pytest.raises(ValueError, match="a film without steps shows nothing"):
        Film([], []).save(page)
    monkeypatch.setattr(
        "rlrobot_edu.widgets.stepper.widget.page_html", lambda *_: 1 / 0
    )
    with pytest.raises(ZeroDivisionError):
        stepper.save(page, 35)
    assert (
        page.read_bytes() == old
        and stepper.t == 30
        and list(tmp_path.iterdir()) == [page]
    )


@pytest.fixture
def opened(browser, tmp_path):
    """Saves a thing's page and opens it; it must ask for nothing but itself, and say nothing on the console."""
    pages, faults, asked = [], [], set()

    def note(text):
        if "GL Driver Message" not in text:  # a slow machine without a graphics card
            faults.append(text)

    def opened(thing, *arguments, link="", **settings):
        thing.save(tmp_path / "page.html", *arguments)
        page = browser.new_page(
            **{"viewport": {"width": 1000, "height": 800}} | settings
        )
        pages.append(page)
        page.on("pageerror", lambda error: faults.append(str(error)))
        page.on("console", lambda said: note(said.text))
        page.on(
            "request",
            lambda request: asked.add(request.url.split("#")[0].split(",")[0]),
        )
        page.goto((tmp_path / "page.html").as_uri() + link)
        if isinstance(thing, BiasExplorer):
            until(
                page, "!!document.querySelector('.rl-bias')"
            )  # a page unpacks itself after it is loaded
        return page

    yield opened
    for page in pages:
        page.close()
    files = {url for url in asked if not url.startswith(("data:image/", "blob:null/"))}
    assert faults == [] and files <= {(tmp_path / "page.html").as_uri()}


def stands(page, number: int, of: int = 30) -> None:
    """Wait until the page shows this number."""
    until(
        page,
        f"where.textContent === 'step {number} of {of}' && slider.value === '{number}'",
    )


def shows(page, number: int, of: int = 30) -> None:
    """Wait until the page shows this number, says it aloud and links to it."""
    stands(page, number, of)
    said = "live.textContent && live.textContent === view.querySelector('.said span').textContent"
    until(page, f"{said} && location.hash === '#{number}'")


def explored(page, numbers, link: str) -> None:
    """Wait until the explorer's page shows all columns of a state, says them aloud and links to them."""
    until(page, f"location.hash === '#{link}'")
    said = page.get_by_role("status").inner_text()
    assert said.startswith(f"State {numbers.s} (") and vector(numbers.bias) in said
    for a, name in enumerate(("advance", "spin left", "spin right")):
        block = page.get_by_role("group", name=name)
        means = block.locator(".rl-means data").all_text_contents()
        assert means == [amount(mean) for mean in numbers.means[:, a]]
        folded, opened = block.locator(".rl-bias-of"), block.locator(".rl-sum b")
        assert folded.text_content() == opened.text_content() == amount(numbers.bias[a])
        chances = block.locator(".rl-chances data").all_text_contents()
        assert chances == 2 * [*percents(numbers.sr[a], numbers.qbiassr[a], 1)]
        bars = "[...e.querySelectorAll('.rl-track')].map((e) => e.firstChild.offsetWidth / e.clientWidth)"
        drawn = block.locator(".rl-chances:visible").evaluate(f"(e) => {bars}")
        assert np.allclose(drawn, [numbers.sr[a], numbers.qbiassr[a]], atol=0.02)


def test_the_explorer_opens_with_its_finding_in_large_type_and_the_columns_of_one_action(
    opened,
):
    """Without a state, at the one of the paper's example; the action is that whose chance the bias changes most."""
    explorer = BiasExplorer("worked_example", TABLES)
    numbers = explorer.numbers
    assert explorer.task.states.decode(explorer.state)["theta"].reading == 90
    page = opened(explorer)
    explored(page, numbers, "21-1")
    a = int(np.abs(numbers.qbiassr - numbers.sr).argmax())
    names = ("advance", "spin left", "spin right")
    title = page.locator(".rl-finding b")
    assert title.inner_text() == finding(names, explorer.q, numbers)
    assert f"“{names[a]}”" in title.inner_text()
    assert opened_actions(page) == [names[a]]
    assert page.locator(".rl-action h3, .rl-name").first.inner_text().endswith(names[a])
    other = names[a - 1]
    page.get_by_role("button", name=other).click()
    assert opened_actions(page) == [other]
    page.get_by_role("spinbutton", name=f"Q of state 21, {other}").fill("40")
    page.keyboard.press("Enter")
    assert opened_actions(page) == [other], "an edit opens no other action"
    size = title.evaluate("(e) => parseFloat(getComputedStyle(e).fontSize)")
    body = page.locator(".said").evaluate(
        "(e) => parseFloat(getComputedStyle(e).fontSize)"
    )
    assert size >= 1.8 * body


def opened_actions(page) -> list[str]:
    """The actions of which the columns are seen."""
    opened = page.locator(".rl-action:has(.rl-open:visible)")
    return [block.get_attribute("aria-label") for block in opened.all()]


def test_four_clicks_or_keys_build_the_columns_up_and_at_last_the_choice(opened):
    explorer = BiasExplorer("worked_example", TABLES, state=13)
    numbers, names = explorer.numbers, ("advance", "spin left", "spin right")
    best = numbers.most_changed
    page = opened(explorer)
    page.get_by_role("button", name="Build it up").click()
    for stage in range(5):
        assert opened_actions(page) == [names[best]]
        block = page.get_by_role("group", name=names[best])
        rows, means = (
            block.locator("input:visible").count(),
            block.locator(".rl-means data:visible").count(),
        )
        marks = block.locator(".rl-row").first.locator(".rl-mark").all_inner_texts()
        assert (rows, means) == (1 if stage == 0 else 6, 4 if stage > 1 else 0)
        assert marks == (["●", "▲", "■", "◆"] if stage else []), (
            "the state itself is in every set"
        )
        assert block.locator(".rl-sum b").is_visible() == (stage > 2)
        shares = page.locator(".rl-chances:visible").count()
        assert shares == (3 if stage > 3 else 0)
        assert page.locator("button[value='1']").inner_text() == (
            "1●" if stage else "1"
        )
        if stage == 2:
            page.keyboard.press("ArrowLeft")
            page.keyboard.press("ArrowRight")
            assert f"for {names[best]}" in page.get_by_role("status").inner_text()
        if stage % 2:
            page.keyboard.press("ArrowRight")
        elif stage < 4:
            page.get_by_role("button", name="Next").click()
    explored(page, numbers, "13-1")
    page.get_by_role("button", name="Back").click()
    other = (best + 1) % 3
    page.get_by_role("button", name=names[other]).click()
    assert (
        page.get_by_role("status")
        .inner_text()
        .endswith(f" / 4 = {amount(numbers.bias[other])}.")
    )
    field = page.get_by_role("spinbutton", name=f"Q of state 13, {names[other]}")
    field.focus()
    page.keyboard.press("ArrowRight")
    assert not page.locator(".rl-chances").first.is_visible(), (
        "in a field the key moves the cursor"
    )


def test_a_line_leads_from_every_row_to_its_means_and_from_these_to_the_bias(opened):
    page = opened(BiasExplorer("worked_example", TABLES, state=13))
    page.locator(".rl-fold").nth(1).click()
    # of each curve its ends on the screen, and beside it the middle of what it should meet
    ends = (
        page.locator(".rl-action")
        .nth(1)
        .evaluate(
            """(block) => {
          const middle = (e) => { const r = e.getBoundingClientRect(); return (r.top + r.bottom) / 2; };
          return {
            curves: [...block.querySelectorAll("svg")].map((svg) => [...svg.querySelectorAll("path")].map((path) => {
              const at = (x) => path.getPointAtLength(x).y * svg.getScreenCTM().d + svg.getBoundingClientRect().top;
              return [at(0), at(path.getTotalLength())];
            })),
            rows: [...block.querySelectorAll(".rl-row")].map(middle),
            means: [...block.querySelectorAll(".rl-means > span")].map(middle),
            bias: middle(block.querySelector(".rl-sum b")),
          };
        }"""
        )
    )
    rows, means, (first, second) = ends["rows"], ends["means"], ends["curves"]
    pairs = [(0, 0), (0, 1), (0, 2), (0, 3), (1, 0), (2, 1), (3, 2), (4, 2), (5, 3)]
    assert np.allclose(first, [(rows[k], means[i]) for k, i in pairs], atol=1.5)
    assert np.allclose(second, [(mean, ends["bias"]) for mean in means], atol=1.5)


WIDTHS = """(block) => [...block.querySelectorAll("svg")].map((svg) => [...svg.querySelectorAll("path")].map((path) => {
  const { strokeWidth, strokeDasharray } = getComputedStyle(path);
  return [parseFloat(strokeWidth), strokeDasharray !== "none"];
}))"""


def test_lines_are_as_wide_as_what_they_bring_and_dashed_below_zero(opened):
    explorer = BiasExplorer("worked_example", TABLES, state=13)
    page, numbers, q = opened(explorer), explorer.numbers, explorer.q
    most = max(
        np.abs(numbers.means).max(), np.abs(q).max() / 2
    )  # a set has two or three
    for a, name in enumerate(("advance", "spin left", "spin right")):
        block = page.get_by_role("group", name=name)
        first, second = (np.array(each) for each in block.evaluate(WIDTHS))
        parts = []
        for states in numbers.sets.values():
            parts.append(q[13, a] / len(states))
        for states in numbers.sets.values():
            parts += [q[k, a] / len(states) for k in states if k != 13]
        for lines, brings in ((first, parts), (second, numbers.means[:, a])):
            part = np.minimum(np.abs(brings) / most, 1)
            np.testing.assert_allclose(lines[:, 0], np.maximum(10 * part, 1), atol=0.01)
            np.testing.assert_array_equal(lines[:, 1], np.array(brings) < 0)


def test_every_state_of_the_explorer_answers_a_click_and_a_key(opened):
    explorer = BiasExplorer("worked_example", TABLES, state=13)
    page = opened(explorer, link="#17")
    assert page.evaluate("location.hash") == "#17-1"
    for s in range(24):
        page.click(f".rl-states button[value='{s}']")
        assert page.get_attribute(f"button[value='{s}']", "aria-pressed") == "true"
        explorer.widget.state = s
        explored(page, explorer.numbers, f"{s}-1")
    page.focus("button[value='13']")
    page.keyboard.press("Enter")
    buttons = "[...document.querySelectorAll('[aria-pressed]')]"
    labels = page.evaluate(f"{buttons}.map((e) => [+e.value, e.textContent])")
    marked = {13: "13here", 1: "1●", 19: "19▲", 15: "15■", 17: "17■", 12: "12◆"}
    assert dict(labels) == {s: marked.get(s, str(s)) for s in range(24)}
    colours = dict(
        page.evaluate(
            f"{buttons}.map((e) => [+e.value, e.style.getPropertyValue('--own')])"
        )
    )
    assert {s for s in range(24) if colours[s]} == set(marked) - {13}
    assert len(set(colours.values())) == 1 + 4  # the two of θ are alike
    assert page.evaluate("document.activeElement.value") == "13", (
        "the keyboard stays where it was"
    )
    page.get_by_role("combobox", name="Q-table").select_option("b")
    explorer.widget.state, explorer.widget.table = 13, 1
    explored(page, explorer.numbers, "13-2")
    for name, value in (("X", "1"), ("Y", "1"), ("θ", "90°"), ("d", "1")):
        page.get_by_role("combobox", name=f" {name}").select_option(value)
    explorer.widget.state = 21
    explored(page, explorer.numbers, "21-2")


def test_every_value_that_has_a_say_can_be_edited_and_reset_undoes_it(opened):
    explorer = BiasExplorer("worked_example", TABLES, state=13)
    q = explorer.q
    page = opened(explorer)
    explored(page, explorer.numbers, "13-1")
    before = page.inner_text("main")
    for s, name, a in ((13, "advance", 0), (19, "spin right", 2)):
        page.get_by_role("button", name=name).click()
        page.get_by_role("spinbutton", name=f"Q of state {s}, {name}").fill("-20.125")
        page.keyboard.press("Enter")
        q[s, a] = -20.125
    assert (
        page.evaluate("document.activeElement.ariaLabel") == "Q of state 19, spin right"
    )
    explorer.widget.tables = [q.tolist(), explorer.widget.tables[1]]
    explored(page, explorer.numbers, "13-1")
    saved = opened(explorer)  # now it has the edits
    explored(saved, explorer.numbers, "13-1")
    page.get_by_role("spinbutton", name="Q of state 19, spin right").fill("")
    page.keyboard.press("Tab")
    assert page.input_value("[aria-label='Q of state 19, spin right']") == "-20.125", (
        "nothing is no number"
    )
    page.get_by_role("button", name="Reset Q").click()
    assert page.inner_text("main") == before


def test_a_value_follows_the_pointer_and_the_lines_are_as_wide_as_what_they_carry(
    opened,
):
    """To the right it grows, by the largest |Q| in half a row; a line that carries a loss is dashed."""
    q = np.zeros((24, 3))
    q[0] = 2, 8, -4
    explorer = BiasExplorer("worked_example", {"mine": q}, state=1)
    page = opened(explorer)
    asks = page.locator(".rl-asks")
    nothing = "The robot has learned nothing here. Who can advise it?"
    assert asks.inner_text() == nothing
    lines = "(e) => [...e.querySelectorAll('path')].map((path) => parseFloat(path.style.strokeWidth))"
    blocks = [page.locator(f".rl-action[data-a='{a}']") for a in range(3)]
    widest = [max(block.evaluate(lines)) for block in blocks]
    assert widest[1] > widest[2] > widest[0]
    assert [block.locator(".rl-against").count() for block in blocks] == [0, 0, 2]

    blocks[1].locator(".rl-fold").click()
    row = blocks[1].locator(".rl-row").first
    box = row.bounding_box()
    x, y = box["x"] + 25, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + box["width"] / 4, y, steps=4)
    assert float(row.locator("input").input_value()) == pytest.approx(4, abs=0.2)
    page.mouse.up()
    page.mouse.move(x, y)
    value = float(row.locator("input").input_value())
    assert value == pytest.approx(4, abs=0.2)
    assert asks.inner_text() == "What do similar states advise the robot here?"
    q[1, 1] = value
    explorer.widget.tables = [q.tolist()]
    explored(page, explorer.numbers, "1")


def test_all_views_of_a_widget_and_its_kernel_show_the_same(browser):
    page, widget = (
        browser.new_page(),
        BiasExplorer("worked_example", TABLES, state=13).widget,
    )
    told = {
        name: getattr(widget, name)
        for name in ("about", "state", "table", "tables", "stage")
    }
    page.set_content("<main></main><main></main>")
    page.add_style_tag(content=widget._css)
    page.add_script_tag(content=widget._esm.replace("export default", "const shown ="))
    page.evaluate(
        """(told) => { // as anywidget's: whoever changes it, all are told
          const heard = new Set();
          const model = { get: (name) => told[name], save_changes() {}, on: (_, hear) => heard.add(hear) };
          Object.assign(model, { off: (_, hear) => heard.delete(hear) });
          model.set = (name, value) => { told[name] = value; heard.forEach((hear) => hear()); };
          window.told = told;
          window.model = model;
          window.ends = [...document.querySelectorAll("main")].map((el) => shown.render({ model, el }));
        }""",
        told,
    )
    page.locator("button[value='4']").first.click()
    assert page.evaluate("told.state") == 4, "the kernel is told"
    page.evaluate("model.set('table', 1)")
    first, second = page.locator("main").all_inner_texts()
    assert first == second and "State 4 (" in first
    page.evaluate("ends[1]()")
    page.locator("button[value='5']").first.click()
    assert page.locator("main").all_inner_texts()[1] == second
    page.close()


def test_a_link_leads_to_a_state_and_a_table(opened):
    explorer = BiasExplorer("worked_example", TABLES, state=13)
    page = opened(explorer, link="#7-2")
    explorer.widget.state, explorer.widget.table = 7, 1
    explored(page, explorer.numbers, "7-2")
    for link, now in (
        ("#3-1", "3-1"),
        ("#5", "5-1"),
        ("#6-9", "6-2"),
        ("#8-0", "8-1"),
        ("#99", "23-1"),
    ):
        page.evaluate("link => { location.hash = link; }", link)
        until(page, f"location.hash === '#{now}'")
        assert page.inner_text(".said").startswith(f"State {now[:-2]} (")


def nine_actions() -> BiasExplorer:
    outputs = [
        rl.OutputVariable(f"{side}_wheel", values=[-1, 0, 1], unit="rad/s")
        for side in ("left", "right")
    ]
    task = replace(rl.load_task("wander_simple"), outputs=outputs)
    return BiasExplorer(
        task, {"random": np.random.default_rng(3).normal(-20, 5, size=(4, 9))}
    )


@pytest.mark.parametrize("width", [400, 1000])
def test_nine_actions_have_room_on_a_small_page_too(opened, width):
    page = opened(nine_actions(), viewport={"width": width, "height": 800})
    assert page.evaluate("document.documentElement.scrollWidth") == width
    picture = page.get_by_role("region", name="Four columns")
    picture.locator(".rl-fold").nth(7).focus()
    page.keyboard.press("Enter")
    page.keyboard.press("Tab")
    right = "document.activeElement.getBoundingClientRect().right"
    until(
        page,
        f"{right} <= {width} && document.activeElement.ariaLabel.startsWith('Q of state 0, left_wheel')",
    )
    assert picture.evaluate("(e) => e.scrollWidth <= e.clientWidth"), (
        "nothing of the picture is hidden"
    )


def test_a_replay_that_was_hidden_at_first_is_there_once_it_is_shown(browser, tmp_path):
    show_scene(SCENES, FILM.rewards).save(tmp_path / "replay.html")
    page = browser.new_page(viewport={"width": 500, "height": 400})
    (tmp_path / "page.html").write_text(
        '<iframe src="replay.html" width=400 height=300 style="display: none"></iframe>'
    )
    page.goto((tmp_path / "page.html").as_uri())
    frame = page.frames[1]
    until(frame, "last === 19")
    page.evaluate("document.querySelector('iframe').style.display = 'block'")
    camera = "viewer.camera.aspect > 1 && viewer.camera.projectionMatrix.elements.every(isFinite)"
    until(frame, f"view.clientWidth === 400 && {camera}")
    seen = np.asarray(
        Image.open(io.BytesIO(page.locator("iframe").screenshot())).convert("RGB")
    )
    assert len(np.unique(seen[20:200, 20:380].reshape(-1, 3), axis=0)) > 50, (
        "the room has many shades"
    )
    page.close()


def test_a_replay_in_3d_has_links_and_keys_and_is_said_aloud(opened):
    def rests(number: int) -> None:
        until(
            page,
            f"live.textContent.startsWith('step {number} of 20') && location.hash === '#{number}'",
        )

    page = opened(
        show_scene(SCENES, FILM.rewards),
        link="#7",
        viewport={"width": 400, "height": 300},
    )
    rests(7)
    for key, number in (("ArrowRight", 8), ("Home", 1), ("End", 20), ("ArrowLeft", 19)):
        page.keyboard.press(key)
        rests(number)
    for name, number in (("step", 20), ("first", 1), ("last", 20), ("back", 19)):
        page.click(f"button[name={name}]")
        rests(number)
    page.evaluate("location.hash = '#3'")
    until(page, "caption.textContent.startsWith('step 3 of 20')")
    page.evaluate(
        "document.activeElement.blur()"
    )  # a button that has the focus takes the space for itself
    page.keyboard.press(" ")
    until(page, "at > 3 && play.textContent === '‖ Pause'")
    page.click("#play")
    until(page, "!playing && play.textContent === '▶▶ Play'")


REFUSED = """async () => {
  const refused = new Set(), add = it => document.body.append(it), elsewhere = {src: "http://127.0.0.1:9/"};
  document.addEventListener("securitypolicyviolation", event => refused.add(event.effectiveDirective));
  await new Promise(done => setTimeout(done));  // playwright's own program may do what the page's may not
  try { eval("refused.add('nothing')"); } catch {}
  for (const name of ["img", "iframe", "script"]) add(Object.assign(document.createElement(name), elsewhere));
  await fetch(elsewhere.src).catch(() => {});
  for (let i = 0; i < 600 && (refused.size < 5 || i === 0); i++) await new Promise(done => setTimeout(done, 100));
  return [...refused].sort();
}"""


def test_a_page_may_ask_for_nothing_and_run_no_string_as_a_program(browser, tmp_path):
    show_scene(SCENES).save(tmp_path / "page.html")
    page = browser.new_page()
    page.goto((tmp_path / "page.html").as_uri())
    assert page.evaluate(REFUSED) == [
        "connect-src",
        "frame-src",
        "img-src",
        "script-src",
        "script-src-elem",
    ]
    page.close()


OUTLINE = ("heading-order", "landmark-one-main", "page-has-heading-one", "region")


@pytest.mark.parametrize(("scheme", "width"), [("light", 1300), ("dark", 400)])
def test_pages_can_be_read_by_all_in_light_and_dark(opened, scheme, width):
    axe = pytest.importorskip(
        "axe_playwright_python.sync_playwright", reason="needs axe-playwright-python"
    ).Axe()
    explorer = BiasExplorer("worked_example", TABLES, state=13)
    things = [
        (stepper_of(at=25), [30], "!!window.stepper"),
        (explorer, [], "!!document.querySelector('.rl-bias')"),
        (show_scene(SCENES), [], "last === 19 && !bar.hidden"),
    ]
    for thing, arguments, is_there in things:
        page = opened(
            thing,
            *arguments,
            color_scheme=scheme,
            viewport={"width": width, "height": 800},
        )
        until(page, is_there)
        back = page.evaluate("getComputedStyle(document.body).backgroundColor")
        assert (sum(map(int, re.findall(r"\d+", back))) < 200) == (scheme == "dark")
        found = axe.run(page, options={"resultTypes": ["violations"]})
        serious = [
            each
            for each in found.response["violations"]
            if each["impact"] in ("serious", "critical") or each["id"] in OUTLINE
        ]
        assert not serious, [
            (each["id"], [node["html"][:200] for node in each["nodes"]][:3])
            for each in serious
        ]
        assert page.evaluate("document.documentElement.scrollWidth") == width


def test_a_browser_that_cannot_unpack_says_so(opened, browser, tmp_path):
    show_scene(SCENES).save(tmp_path / "old.html")
    page = browser.new_page()
    page.add_init_script("delete window.DecompressionStream")
    page.goto((tmp_path / "old.html").as_uri())
    page.get_by_text(
        "This page cannot be unpacked: the browser is older than 2023"
    ).wait_for()
    page.close()
