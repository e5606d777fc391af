"""The stepper in a browser: alone in its file, and beside a kernel that is quick, busy or dead."""

import json

import numpy as np
import pytest
from waiting import until

import rlrobot_edu as rl
from rlrobot_course.lesson_19.credit import credit as credit_in
from rlrobot_edu.widgets.stepper.numerals import short
from rlrobot_edu.widgets.stepper.page_data import feed, frame_data
from rlrobot_edu.widgets.stepper.saved_page import style

Q = "[...document.querySelectorAll('section.q td')].map((td) => td.textContent.replace(/[▲▼]|.* → /g, ''))"
STANDS = "stepper.tape.t === {0} && stepper.find('slider').value === '{0}' && stepper.find('go').value === '{0}'"


def stepper_of(
    task: str = "worked_example", method: str = "TOSL+QBIASSR", **options
) -> rl.Stepper:
    return rl.Stepper(
        rl.Agent(task, method, seed=0), rl.make_env(task, seed=0), **options
    )


@pytest.fixture
def opened(browser, tmp_path):
    """Opens a stepper's file; it must ask for nothing but itself, and say nothing on the console."""
    pages, faults, asked = [], [], set()

    def opened(stepper, steps=None, link="", **settings):
        stepper.save(tmp_path / "page.html", steps)
        page = browser.new_page(
            **{"viewport": {"width": 1000, "height": 800}} | settings
        )
        pages.append(page)
        page.on("pageerror", lambda error: faults.append(str(error)))
        page.on("console", lambda said: faults.append(said.text))
        page.on("request", lambda request: asked.add(request.url.split("#")[0]))
        page.goto((tmp_path / "page.html").as_uri() + link)
        until(page, "!!window.stepper")
        return page

    yield opened
    for page in pages:
        page.close()
    files = {url for url in asked if not url.startswith("blob:null/")}
    assert faults == [] and files <= {(tmp_path / "page.html").as_uri()}


def stands(page, t: int) -> None:
    """Wait until the page shows this step."""
    until(page, STANDS.format(t))


def unfold(page) -> None:
    """Open what asks what another setting would do."""
    asks = page.locator("details", has_text="What if?")
    asks.evaluate("(e) => { e.open = true; }")


def test_buttons_keys_and_slider_lead_through_the_steps(opened):
    page = opened(stepper_of(at=5), 30)
    stands(page, 5)
    for name, t in (
        ("step", 6),
        ("back", 5),
        ("last", 30),
        ("step", 30),
        ("first", 0),
        ("back", 0),
    ):
        page.click(f"button[name={name}]")
        stands(page, t)
    for key, t in (
        ("ArrowRight", 1),
        ("ArrowRight", 2),
        ("End", 30),
        ("ArrowLeft", 29),
        ("Home", 0),
    ):
        page.keyboard.press(key)
        stands(page, t)
    page.focus(".rl-slider")
    page.keyboard.press("PageUp")  # the slider's own
    until(page, "stepper.tape.t > 0")
    page.fill(".rl-go", "12")
    page.keyboard.press("Enter")
    stands(page, 12)
    agent = rl.Agent("worked_example", "TOSL+QBIASSR", seed=0)
    rl.learn(agent, rl.make_env("worked_example", seed=0), steps=12, progress=False)
    numbers = [
        short(value) if n else "·"
        for value, n in zip(agent.q.flat, agent.visits.flat, strict=True)
    ]
    assert page.evaluate(Q) == numbers
    page.focus("summary")
    page.keyboard.press(" ")  # opens the whole table, and plays nothing
    until(page, "document.querySelector('details').open && !stepper.player")


@pytest.mark.parametrize("viewport", [(1280, 500), (390, 700)])
def test_the_buttons_do_not_cover_what_is_focused_and_a_phone_has_no_keys(
    opened, viewport
):
    width, height = viewport
    page = opened(stepper_of(at=5), viewport={"width": width, "height": height})
    assert page.locator(".rl-keys").is_visible() == (width > 560)
    page.locator("summary", has_text="Why?").click()
    hidden = """() => {
      const { top, bottom } = document.activeElement.getBoundingClientRect();
      const bar = document.querySelector(".rl-bar"), { top: from, bottom: to } = bar.getBoundingClientRect();
      const elsewhere = bar.contains(document.activeElement) || document.activeElement === document.body;
      return !elsewhere && top < to && bottom > from;
    }"""
    for key in ["Tab"] * 14 + ["Shift+Tab"] * 14:
        page.keyboard.press(key)
        assert not page.evaluate(hidden), key


@pytest.mark.parametrize("viewport", [(1280, 800), (390, 844)])
@pytest.mark.parametrize("task", ["worked_example", "wander_1k"])
def test_the_first_screen_has_what_happened_and_the_whole_room_before_all_formulas(
    opened, task, viewport
):
    width, height = viewport
    page = opened(stepper_of(task, at=20), viewport={"width": width, "height": height})
    places = """() => {
      const box = (name) => document.querySelector(name).getBoundingClientRect(), bar = box(".rl-bar");
      const says = box(".did"), room = box(".world .room"), formulas = box(".line");
      const free = bar.top > says.top ? bar.top : innerHeight;  // on a phone the buttons are below
      return [says.bottom, room.top, room.bottom, free, formulas.top, formulas.left - room.right];
    }"""
    said, top, bottom, free, formulas, beside = page.evaluate(places)
    assert said <= top < bottom <= free
    assert formulas > bottom or beside > 0


def test_a_key_counts_at_once_and_play_at_the_end_begins_again(opened):
    page = opened(stepper_of(at=30))
    page.keyboard.press("ArrowLeft")
    stands(page, 29)
    page.keyboard.press("End")
    stands(page, 30)
    page.click("button[name=play]")
    until(page, "stepper.player !== null && stepper.tape.t < 10")
    until(page, "stepper.tape.t > stepper.tape.first")


def test_no_label_of_a_cell_lies_on_the_robot(opened):
    page = opened(stepper_of(at=30))
    overlaps = """() => {
      const inner = (e) => e.getBoundingClientRect(), box = inner(document.querySelector(".world canvas"));
      const { scene } = stepper.about.view, { place } = stepper.tape.looks().at(-1);
      const [{ outline }] = stepper.about.rooms[0];
      const view = RoomView.of(scene.bounds, box.width, box.height);
      const at = outline.map((point) => view.seenFrom(place, point));
      const xs = at.map(([x]) => box.left + x), ys = at.map(([, y]) => box.top + y);
      const robot = { left: Math.min(...xs), right: Math.max(...xs), top: Math.min(...ys), bottom: Math.max(...ys) };
      const chips = [...document.querySelectorAll(".world .chip .under")].map(inner);
      const meet = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
      return [chips.length, chips.filter((chip) => meet(chip, robot)).length, robot.right - robot.left];
    }"""
    chips, on_it, width = page.evaluate(overlaps)
    assert chips > 0 and on_it == 0 and width > 20


def test_a_change_is_written_so_that_it_can_be_seen(opened):
    """Where the old and the new value look the same, the cell says by how much they differ."""
    env = rl.make_env("wander_1k", seed=0, engine="kinematic")
    page = opened(rl.Stepper(rl.Agent("wander_1k", "TOSL+SR", seed=0), env, at=40))
    cells = """[...document.querySelectorAll("section.q td.new")].map((e) => {
      const [told, now] = [e.querySelector("small").textContent, e.lastChild.textContent];
      return [told, now];
    })"""
    seen = []
    for t in range(20, 41):
        page.evaluate(f"stepper.go({t})")
        seen += page.evaluate(cells)
    assert all(told != f"{now} → " for told, now in seen)
    assert any("→" not in told for told, _ in seen), "none looked the same"
    assert page.evaluate("writerFor(1.2804, 1.2801)(1.2804)") == "1.2804"
    assert page.evaluate("writerFor(0.5, 0.7)(0.5)") == "0.500"


def test_a_link_leads_to_its_step_and_a_wrong_one_to_what_was_shown(opened):
    page = opened(stepper_of(at=5), 30, link="#31")
    stands(page, 30)  # there are no more
    until(
        page,
        "location.hash === '#30' && stepper.find('live').textContent.startsWith('Step 30 (')",
    )
    page.evaluate("location.hash = '#17'")
    stands(page, 17)
    page.evaluate("location.hash = '#nonsense'")
    stands(page, 17)
    stands(opened(stepper_of(at=5), 30, link="#-3"), 5)


def test_it_plays_to_the_end_and_a_key_or_a_click_stops_it(opened):
    page = opened(stepper_of(at=0), 30)
    stands(page, 0)
    page.select_option(".rl-speed", "30")
    page.click("button[name=play]")
    until(page, "stepper.tape.t > 2")
    page.keyboard.press("ArrowLeft")
    until(page, "!stepper.player && stepper.find('play').textContent === '▶▶ Play'")
    page.evaluate("document.activeElement.blur()")
    page.keyboard.press(" ")
    until(
        page, "stepper.find('play').textContent === '‖ Pause' || stepper.tape.t === 30"
    )
    stands(page, 30)
    until(page, "!stepper.player")


def test_another_alpha_is_learned_anew_on_the_page_and_back_again(opened):
    page = opened(stepper_of(method="TOSL+SR", at=40), 60)
    before = page.evaluate(Q)
    unfold(page)
    page.get_by_role("combobox", name="α").select_option("0.5")
    until(page, "stepper.find('parted').textContent.includes('With α = 0.5')")
    agent = rl.Agent("worked_example", "TOSL+SR", alpha=0.5, seed=0)
    rl.learn(agent, rl.make_env("worked_example", seed=0), steps=40, progress=False)
    np.testing.assert_array_equal(
        page.evaluate("stepper.tape.q.map((row) => [...row])"), agent.q
    )
    assert (
        "goes another way from step" in page.inner_text(".rl-parted")
        and page.evaluate(Q) != before
    )
    page.click("button[name=last]")
    stands(page, 60)
    page.click("button[name=step]")  # beyond what was saved: the page lives on
    stands(page, 61)
    page.fill(".rl-go", "40")
    page.keyboard.press("Enter")
    page.get_by_role("button", name="As it was").click()
    until(page, "stepper.tape === stepper.recorded")
    stands(page, 40)
    assert page.evaluate(Q) == before and page.inner_text(".rl-parted") == ""


def test_a_click_on_a_value_tells_who_paid_for_it_and_a_click_on_a_step_what_else_it_paid(
    opened,
):
    page = opened(stepper_of(method="TOSL+SR", at=200))
    assert page.inner_text(".rl-paid") == ""
    page.locator("details.all summary").click()
    page.click(f"section.q td[data-at='{13 * 3 + 1}']")
    page.get_by_role("combobox", name="rather than").select_option("0")
    said = page.inner_text(".rl-paid p[role=status]")
    credit = credit_in(
        rl.Agent("worked_example", "TOSL+SR", seed=0),
        rl.make_env("worked_example", seed=0),
        200,
    )
    left, ahead = credit.shares(13, 1), credit.shares(13, 0)
    most, second, third = np.argsort(-abs(left - ahead))[:3]
    its = credit.steps[most]
    assert (
        f"= {(left - ahead).sum():.2f}. {np.count_nonzero(left - ahead)} of 200 steps paid for it; most: "
        in said
    )
    assert (
        f"step {most + 1}, a = {its.a} (advance) in s = {its.s} for r = {its.r:g}: +{(left - ahead)[most]:.2f}"
        in said
    )
    assert (
        f"+{(left - ahead)[second]:.3f} (spin left +{left[second]:.3f}, advance {ahead[second]:.2f})"
        in said
    )
    assert page.locator(
        "svg .lit"
    ).count() == 12 and f"What step {most + 1} has paid" in page.inner_text(".rl-paid")
    page.click(f".rl-paid .time rect[data-step='{second + 1}']")
    until(
        page,
        f"document.querySelector('.rl-paid').textContent.includes('What step {second + 1} has paid')",
    )
    page.get_by_role("button", name=f"step {third + 1}").click()
    until(
        page,
        f"document.querySelector('.rl-paid').textContent.includes('What step {third + 1} has paid')",
    )
    assert "By Q alone, at T = 1, that makes spin left" in page.inner_text(".rl-paid")
    page.click(f".rl-paid [data-go='{third + 1}']")
    stands(page, third + 1)
    page.keyboard.press("Home")
    stands(page, 0)
    assert "No step has paid for it." in page.inner_text(".rl-paid")
    page.click("button[name=last]")
    page.get_by_role("button", name="What did the step shown pay?").click()
    assert "What step 200 has paid" in page.inner_text(".rl-paid")
    page.get_by_role("button", name="Enough").click()
    assert page.inner_text(".rl-paid") == "" and page.locator("svg .lit").count() == 0


def test_a_click_on_a_bias_tells_whose_advice_it_was(opened):
    page = opened(stepper_of(at=24))
    *_, step = rl.steps(
        rl.Agent("worked_example", "TOSL+QBIASSR", seed=0),
        rl.make_env("worked_example", seed=0),
        24,
    )
    words = ("advance", "spin left", "spin right")

    def of(a):
        return f"bias({step.s}, {a} ({words[a]})) = {step.bias[a]:.3f} in step 24."

    other = 3 - step.a  # of the two turns, the one that was not made
    page.locator("[data-bias]").nth(other).click()
    assert of(other) in page.inner_text(".rl-paid p[role=status]")
    page.locator(".rl-paid [data-at]").first.click()
    assert "steps paid for it" in page.inner_text(".rl-paid p[role=status]")
    page.get_by_role("button", name="Whose advice was the bias?").click()
    assert of(step.a) in page.inner_text(".rl-paid p[role=status]"), (
        "of the action that was chosen"
    )


def test_a_fork_shows_both_futures_side_by_side(opened):
    page = opened(stepper_of(method="TOSL+SR", at=60), 120)
    a = page.evaluate("stepper.tape.frame.a")
    unfold(page)
    page.get_by_role("button", name="from the step shown").click()
    assert page.evaluate("stepper.tape === stepper.recorded"), "nothing was changed yet"
    page.get_by_role("combobox", name="in that step a =").select_option(
        str((a + 1) % 3)
    )
    assert (
        "in step 60 and the same luck it goes another way from step 60 on"
        in page.inner_text(".rl-parted")
    )
    assert page.evaluate("[stepper.tape.frame.a, stepper.recorded.frame.a]") == [
        (a + 1) % 3,
        a,
    ]
    assert page.locator(
        ".rl-futures section"
    ).count() == 2 and "they part in step 60" in page.inner_text(".rl-futures")
    page.get_by_role("combobox", name="in that step a =").select_option("")
    page.get_by_role("spinbutton", name="r =").fill("50")
    page.keyboard.press("Enter")
    until(page, "stepper.find('parted').textContent.includes('r = 50 in step 60')")
    page.get_by_role("combobox", name="learn by").select_option(label="SARSA")
    until(
        page, "stepper.find('futures').textContent.includes('What if, step 60: SARSA')"
    )
    page.get_by_role("button", name="As it was").click()
    assert (
        page.evaluate("stepper.tape === stepper.recorded")
        and page.inner_text(".rl-futures") == ""
    )


class Notebook:
    """A page with the stepper's program, and a kernel that answers when it is told to."""

    def __init__(self, page, stepper: rl.Stepper) -> None:
        self.page, self.stepper, tape = page, stepper, stepper._tape
        page.set_content("<main></main><script>window.asked = []</script>")
        told = json.dumps(feed(tape, stepper._names, stepper.t))
        made = f"window.stepper = new Stepper({told}, replayData, (question) => asked.push(question));"
        text = f"{stepper._script()}\n{made}"
        page.add_style_tag(content=style())
        page.add_script_tag(
            content=text + "stepper.mount(document.querySelector('main'));"
        )

    def answer(self) -> None:
        """Answer the oldest question with what the library says to it."""
        until(self.page, "asked.length > 0")
        (end,), question = [self.stepper._tape.end], self.page.evaluate("asked.shift()")
        self.stepper._hear(question)
        frames = [
            frame_data(frame, self.stepper._tape)
            for frame in self.stepper._tape.since(end)
        ]
        self.page.evaluate("news => stepper.hear(news)", {"frames": frames})


@pytest.fixture
def notebook(browser):
    page, faults = browser.new_page(viewport={"width": 1000, "height": 900}), []
    page.on("pageerror", lambda error: faults.append(str(error)))
    yield lambda stepper: Notebook(page, stepper)
    page.close()
    assert faults == []


def test_held_keys_wait_for_the_kernel_and_what_is_there_needs_none(notebook):
    one = notebook(stepper_of(at=12))
    page = one.page
    page.click(".rl-view .choice h2")
    assert page.evaluate("document.activeElement.className") == "rl-keys"
    for _ in range(5):
        page.keyboard.down("ArrowRight")  # held
    assert page.evaluate("asked") == [{"take": 1}]
    one.answer()
    stands(page, 13)
    page.evaluate("asked.length = 0")
    for key, t in (("ArrowLeft", 12), ("Home", 0), ("End", 13)):
        page.keyboard.press(key)
        stands(page, t)
    until(
        page, "asked.at(-1)?.at === 13"
    )  # the kernel hears where the view rests, and of nothing else
    assert "take" not in json.dumps(page.evaluate("asked"))


def test_a_kernel_that_does_not_answer_is_missed_and_the_steps_stay(notebook):
    one = notebook(stepper_of(at=12))
    page = one.page
    page.click("button[name=step]")
    page.get_by_text("The kernel does not answer").wait_for()
    page.click("button[name=back]")
    stands(page, 11)
    unfold(page)
    page.get_by_role("combobox", name="α").select_option("1")
    until(page, "stepper.find('parted').textContent.includes('α = 1')")
    for t in (12, 13):  # a life of the page's own goes on without a kernel
        page.click("button[name=step]")
        stands(page, t)
    page.get_by_role("button", name="As it was").click()
    stands(page, 12)
    page.evaluate("asked.length = 0")
    page.click("button[name=step]")
    one.answer()
    stands(page, 13)
    assert page.inner_text(".rl-said") == ""


def test_a_jump_far_ahead_goes_in_slices_and_can_be_stopped(notebook):
    one = notebook(stepper_of(at=1))
    page = one.page
    page.evaluate(
        "window.setTimeout = () => 0"
    )  # a busy machine may answer late: the page shall not give it up
    page.fill(".rl-go", "250")
    page.keyboard.press("Enter")
    for _ in range(3):
        one.answer()
    stands(page, 250)
    page.evaluate("asked.length = 0")
    page.fill(".rl-go", "1000000")
    page.keyboard.press("Enter")
    one.answer()
    page.get_by_text("on the way to step 1000000. Pause stops it.").wait_for()
    page.get_by_role("button", name="Pause").click()
    page.get_by_text("Stopped at step 350, on the way to step 1000000.").wait_for()


def test_nothing_is_cut_off_at_any_width_and_terms_point_at_their_cells(notebook):
    page = notebook(stepper_of(at=12)).page
    page.hover(".line .to-pair")
    assert (
        page.evaluate(
            "getComputedStyle(document.querySelector('.choice td.pair')).outlineWidth"
        )
        == "4px"
    )
    for width in (390, *range(460, 1900, 120)):
        page.set_viewport_size({"width": width, "height": 900})
        cut = page.evaluate(
            "[...document.querySelectorAll('.rl-stepper *')].filter(e => e.clientWidth && e.scrollWidth > "
            "e.clientWidth + 1 && !e.closest('.rl-live') || e.getBoundingClientRect().right > innerWidth)"
            ".map(e => e.outerHTML)"
        )
        assert cut == [], width
