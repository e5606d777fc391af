"""The stage in a browser: what is drawn is where it belongs, what is pressed and moved tells, and all can use it."""

from __future__ import annotations

import numpy as np
import pytest
from waiting import until

import rlrobot_edu as rl

SIZES = {
    "wide": (1280, 800),
    "phone": (390, 844),
    "tablet": (820, 1000),
    "small": (1024, 768),
}
FOLDED = ("tablet", "small")  # here one has to scroll for the honest line
NUMBERS = """() => {
  const metres = lives.map((life) => life.metres[HOUR]);
  return [moment.t, chosen, ghost, chancesNow(), moment.known.map(sayNow), metres, walls];
}"""


@pytest.fixture(scope="module")
def opened(browser, tmp_path_factory):
    """Opens the page; it must ask for nothing but itself, and say nothing on the console."""
    file = tmp_path_factory.mktemp("stage") / "page.html"
    pages, faults, asked = [], [], set()
    rl.stage(file)

    def opened(link="", size="wide", **settings):
        width, height = SIZES[size]
        page = browser.new_page(
            viewport={"width": width, "height": height},
            **{"reduced_motion": "reduce"} | settings,
        )
        pages.append(page)
        page.on("pageerror", lambda error: faults.append(str(error)))
        page.on("console", lambda said: faults.append(said.text))
        page.on("request", lambda request: asked.add(request.url.split("#")[0]))
        page.goto(file.as_uri() + link)
        return page

    yield opened
    for page in pages:
        page.close()
    assert faults == [] and asked == {file.as_uri()}


@pytest.fixture(scope="module", params=SIZES)
def calm(opened, request):
    """The page for a reader who wants no motion: it opens at the arrow."""
    page = opened(size=request.param)
    until(page, "phase === 'ask' && !isMoving")
    return page


def test_without_motion_it_opens_at_the_arrow_and_tells_what_came(calm):
    said = calm.locator("#said").inner_text()
    assert "memories of similar places say: " in said and "t did " in said
    assert "itself, earlier" in calm.locator("#lead").inner_text()
    assert calm.evaluate("stepPart(seconds())") == 0
    assert calm.locator("#motions [aria-pressed=true]").count() == 1


LETTER = """(where) => parseFloat(getComputedStyle(document.querySelector(where)).fontSize)"""


def test_the_finding_is_the_title_and_bumps_are_told_in_words(calm):
    assert calm.evaluate(LETTER, "#said b") > calm.evaluate(LETTER, "h1")
    bumps = calm.evaluate("lives.map(({ bumps }) => bumps[HOUR])")
    assert (
        f"(these two: {bumps[0]} and {bumps[1]})"
        in calm.locator("#honest").inner_text()
    )
    assert "bump" not in calm.locator("#stage").inner_text()


HELD = """() => { // how many of the pixels around each robot's middle have its colour, and whether that is in the room
  const { robot, ghosts } = layoutNow(), sheet = document.createElement("canvas"), half = 4;
  Object.assign(sheet, { width: canvas.width, height: canvas.height });
  const context = sheet.getContext("2d", { willReadFrequently: true });
  context.drawImage(canvas, 0, 0);
  const held = ([x, y], tone) => {
    const box = [x - half, y - half, 2 * half, 2 * half].map((side) => side * ratio);
    const { data } = context.getImageData(...box), wanted = tone.match(/[\\d.]+/g).map(Number);
    const away = (i) => sum([0, 1, 2], (k) => Math.abs(data[i + k] - wanted[k]));
    const starts = Array.from({ length: data.length / 4 }, (_, i) => 4 * i);
    return starts.filter((i) => away(i) < 12).length / starts.length;
  };
  const [xMin, yMin, xMax, yMax] = lives[1].world.bounds, camera = cameraNow();
  const isInside = (spot) => {
    const [x, y] = camera.from(...spot);
    return x > xMin && x < xMax && y > yMin && y < yMax + 0.2; // the top of a robot is seen farther back
  };
  const loud = ghosts.filter(speaks).map((one) => [one.spot, ghostTone(one.input, colours)]);
  return [[robot, colours.blue], ...loud].map(([spot, tone]) => [held(spot, tone), isInside(spot)]);
}"""


def test_robot_and_ghosts_are_drawn_where_they_stand_inside_the_room(calm):
    shares, inside = zip(*calm.evaluate(HELD), strict=True)
    assert len(shares) > 3 and all(inside)
    assert min(shares) > 0.2, "their marks hide a part"
    assert shares[0] > 0.7


ACROSS = """() => layoutNow().ghosts.filter(speaks).map((one) => { // the width of each ribbon across its middle
  const sheet = Object.assign(document.createElement("canvas"), { width: canvas.width, height: canvas.height });
  const context = sheet.getContext("2d");
  context.setTransform(8, 0, 0, 8, 0, 0);
  const [from, middle, to] = [0.45, 0.5, 0.55].map((p) => along(one.curve, p)), size = 60;
  context.translate(size / 2 - middle[0], size / 2 - middle[1]);
  drawRibbon(context, one, 1, 1, colours);
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]], long = Math.hypot(dx, dy);
  const { data } = context.getImageData(0, 0, 8 * size, 8 * size);
  let wide = 0;
  for (let far = -size / 2; far < size / 2; far += 0.05) {
    const x = Math.floor(8 * (size / 2 - (far * dy) / long)), y = Math.floor(8 * (size / 2 + (far * dx) / long));
    if (data[4 * (y * 8 * size + x) + 3] > 127) wide += 0.05;
  }
  return [wide, Math.abs(one.say)];
})"""


def test_ribbons_are_as_wide_as_what_their_ghosts_say(calm):
    wide, says = np.array(calm.evaluate(ACROSS)).T
    assert len(says) > 2
    np.testing.assert_allclose(wide / says, (wide / says)[0], rtol=0.1, atol=0.2)
    assert wide.max() / wide.min() > 2


LETTERS = """() => {
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), small = [];
  while (walker.nextNode()) {
    const { parentElement: element, data } = walker.currentNode;
    if (!data.trim() || /^(SCRIPT|STYLE|NOSCRIPT)$/.test(element.tagName) || !element.checkVisibility()) continue;
    if (parseFloat(getComputedStyle(element).fontSize) < 13) small.push(data);
  }
  return small;
}"""
TOLD = "h1, #sub, .score, #said, #honest, #lot, #motions button, #lead, #ghosts button, #marks, summary"
OVERLAPS = """(told) => {
  const seen = [...document.querySelectorAll(told)].filter((element) => element.checkVisibility());
  const boxes = seen.map((element) => [element.id || element.textContent, element.getBoundingClientRect()]);
  const common = (a, b, from, to) => Math.min(a[to], b[to]) - Math.max(a[from], b[from]);
  const lies = (a, b) => common(a, b, "left", "right") > 1 && common(a, b, "top", "bottom") > 1;
  const over = (i) => boxes.slice(i + 1).filter(([, box]) => lies(boxes[i][1], box));
  return boxes.flatMap(([one], i) => over(i).map(([other]) => [one, other]));
}"""


def test_letters_can_be_read_and_nothing_lies_over_them(calm):
    assert calm.evaluate(LETTERS) == []
    assert calm.evaluate(OVERLAPS, TOLD) == []
    assert calm.evaluate("document.documentElement.scrollWidth <= innerWidth")


def test_the_honest_line_is_seen_without_scrolling(calm):
    size = (calm.viewport_size["width"], calm.viewport_size["height"])
    if size in [SIZES[name] for name in FOLDED]:
        return
    calm.evaluate("scrollTo(0, 0)")
    assert bottom_of(calm, "#honest") <= calm.viewport_size["height"]


def bottom_of(page, selector: str) -> float:
    box = page.locator(selector).bounding_box()
    return box["y"] + box["height"]


@pytest.mark.parametrize("touch", [False, True])
def test_a_phones_first_screen_has_finding_robot_buttons_and_all_motions(opened, touch):
    page = opened(size="phone", has_touch=touch)
    until(page, "phase === 'ask' && !isMoving")
    assert page.locator("#motions button").count() == 7
    for part in ("#said", "#picture", "#keys", "#motions"):
        assert bottom_of(page, part) <= SIZES["phone"][1], part


BADGE = """() => { // how far the badge is from each robot's middle, as a part of a robot's radius
  const camera = cameraNow(), context = canvas.getContext("2d"), radius = 0.3 * camera.scale;
  const badge = { text: "83 %", small: "would drive ahead, fast", narrow: isNarrow() };
  const shown = layoutNow(), others = shown.ghosts.map(({ spot }) => spot);
  const rect = [camera.left, camera.top, camera.wide, camera.high], [w, h] = badgeSize(context, badge);
  const { spot } = besideRobot([w, h], shown.robot, shown.robot, others, rect, radius);
  const away = (a, b, half) => Math.max(0, Math.abs(a - b) - half);
  const far = ([x, y]) => Math.hypot(away(x, spot[0], w / 2), away(y, spot[1], h / 2));
  return [shown.robot, ...others].map((one) => far(one) / radius);
}"""


def test_what_it_would_do_is_written_beside_the_robots_and_hides_none(calm):
    assert min(calm.evaluate(BADGE)) > 0.9


THUMBNAIL = """() => { // of the left room: parts of its pixels that are wall, floor and way; where it is
  const camera = new Camera(lives[0].world.bounds, placesOf(1).rooms[0]), box = canvas.getBoundingClientRect();
  const sheet = Object.assign(document.createElement("canvas"), { width: canvas.width, height: canvas.height });
  const context = sheet.getContext("2d", { willReadFrequently: true });
  context.drawImage(canvas, 0, 0);
  const place = [camera.left, camera.top, camera.wide, camera.high];
  const { data } = context.getImageData(...place.map((side) => side * ratio));
  const greener = (i) => data[i + 1] - Math.max(data[i], data[i + 2]) > 12;
  const starts = Array.from({ length: data.length / 4 }, (_, i) => 4 * i), n = starts.length;
  const bare = starts.filter((i) => data[i + 3] === 0).length / n;
  return { green: starts.filter(greener).length / n, bare, left: camera.left + box.left, top: camera.top + box.top,
    right: camera.left + camera.wide + box.left, bottom: camera.top + camera.high + box.top };
}"""
LETTERS_OF_SCORES = """() => [...document.querySelectorAll(".score :is(b, i, em)")].map((element) => {
  const range = document.createRange();
  range.selectNodeContents(element);
  const { left, right, top, bottom } = range.getBoundingClientRect();
  return { left, right, top, bottom };
})"""


def test_the_left_room_stays_as_a_small_picture_beside_its_number(calm):
    shown = calm.evaluate(THUMBNAIL)
    assert shown["green"] > 0.05, "the way of its hour"
    assert shown["bare"] < 0.3, "a room fills its rectangle but for the corners"
    for letters in calm.evaluate(LETTERS_OF_SCORES):
        beside = shown["left"] >= letters["right"] or shown["right"] <= letters["left"]
        above = shown["top"] >= letters["bottom"] or shown["bottom"] <= letters["top"]
        assert beside or above


def test_axe_finds_nothing(calm):
    assert violations(calm) == []


def test_axe_finds_nothing_in_the_dark_with_a_ghost_chosen(opened):
    page = opened(color_scheme="dark")
    until(page, "phase === 'ask' && !isMoving")
    page.locator("#ghosts button").first.click()
    assert violations(page) == []


def violations(page):
    """What axe finds."""
    axe = pytest.importorskip(
        "axe_playwright_python.sync_playwright", reason="needs axe-playwright-python"
    ).Axe()
    found = axe.run(page, options={"resultTypes": ["violations"]}).response
    return [(each["id"], each["nodes"][0]["html"]) for each in found["violations"]]


def test_a_ghost_that_is_chosen_tells_when_it_was_there_and_shows_what_differs(opened):
    page = opened()
    until(page, "phase === 'ask' && !isMoving")
    page.evaluate("""() => {
      window.beams = [];
      const whole = drawBeam;
      drawBeam = (context, camera, world, place, input, ...rest) => {
        window.beams.push(input);
        whole(context, camera, world, place, input, ...rest);
      };
      window.texts = [];
      const fillText = CanvasRenderingContext2D.prototype.fillText;
      CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) {
        window.texts.push([text, parseFloat(this.font.match(/([\\d.]+)px/)[1])]);
        fillText.call(this, text, ...rest);
      };
      wake();
    }""")
    until(page, "texts.length > 0 && !isMoving")
    assert page.evaluate("beams") == [], "the opening is bare of beams"
    assert min(size for _, size in page.evaluate("texts")) >= 13
    page.evaluate("texts.length = 0")
    page.locator("#ghosts button").nth(1).click()
    until(page, "texts.length > 0 && !isMoving")
    chosen = page.evaluate("moment.known[1]")
    assert page.evaluate("beams") == [chosen["input"]] * 2, "its own, and the robot's"
    told = [text for text, _ in page.evaluate("texts")]
    assert f"itself, minute {chosen['seen'] // 60}" in told


def test_the_main_buttons_come_first(opened):
    page = opened()
    until(page, "phase === 'ask' && !isMoving")
    names = []
    for _ in range(4):
        page.keyboard.press("Tab")
        names.append(page.evaluate("document.activeElement.id"))
    assert names[:3] == ["next", "wrong", "again"]


def test_a_link_holds_motion_ghost_memory_and_walls(opened):
    page = opened()
    until(page, "phase === 'ask' && !isMoving")
    was = page.evaluate(NUMBERS)
    page.locator("#picture").focus()
    page.keyboard.press("w")
    page.keyboard.press("ArrowUp")
    until(page, "walls !== null && later === 0 && phase === 'ask'")
    assert page.evaluate(NUMBERS)[5] != was[5], "in another room they live other hours"
    page.locator("#motions button").nth(4).click()
    page.locator("#ghosts button:visible").first.click()
    page.locator("#value").fill("-80")
    told = page.evaluate(NUMBERS)
    assert told[3] != page.evaluate("moment.chances")
    again = opened("#" + page.url.partition("#")[2])
    until(again, "phase === 'ask' && !isMoving")
    assert again.evaluate(NUMBERS) == told
    page.get_by_role("button", name="Put the walls back").click()
    until(page, "phase === 'ask'")
    assert page.evaluate(NUMBERS) == was


def test_a_wrong_link_harms_nothing(opened):
    page = opened("#t=x&motion=99&ghost=-1&what=1,2;a,b,c&walls=9,9,9,9;x")
    until(page, "phase === 'ask' && !isMoving")
    assert page.evaluate("changed.size") == 0


def test_a_wall_is_dragged_and_a_ribbon_pulled(opened):
    page = opened()
    until(page, "phase === 'ask' && !isMoving")
    was = page.evaluate(NUMBERS)
    box = page.locator("#picture").bounding_box()

    def drag(start, end):
        page.mouse.move(box["x"] + start[0], box["y"] + start[1])
        page.mouse.down()
        page.mouse.move(box["x"] + end[0], box["y"] + end[1], steps=5)
        page.mouse.up()

    middle = page.evaluate("along(layoutNow().ghosts[0].curve, 0.4)")
    drag(middle, (middle[0], middle[1] + 60))
    assert page.evaluate("changed.size") == 1
    assert page.evaluate("chancesNow()") != was[3]
    wall = page.evaluate("inside().findIndex(([x, y]) => x === 1.775 && y === 0.175)")
    drag(
        page.evaluate("cameraNow().at(1.775, 0.175)"),
        page.evaluate("cameraNow().at(1.2, 0.3)"),
    )
    until(page, "phase === 'ask'")
    moved = page.evaluate(f"inside()[{wall}]")
    assert moved[:2] == pytest.approx([1.2, 0.3], abs=0.02)
    assert page.evaluate(NUMBERS)[5] != was[5]


def test_with_motion_they_race_first_and_a_key_leads_to_the_question(opened):
    page = opened(reduced_motion="no-preference")
    until(
        page,
        "phase === 'race' && Number(find('neighbours').querySelector('b').textContent) > 0",
    )
    assert page.locator("#next").is_hidden()
    page.keyboard.press("Escape")
    until(page, "phase === 'ask' && isNear && stepPart(seconds()) === 1")
    first = page.evaluate("moment.t")
    assert "t did " in page.locator("#said").inner_text()
    page.keyboard.press("ArrowRight")
    assert page.evaluate("moment.t") > first
    page.get_by_role("button", name="When it was wrong").click()
    until(page, "find('said').textContent.includes('bump')")
    page.get_by_role("button", name="When it was wrong").click()
    until(page, "find('said').textContent.includes('ten steps earned')")
    assert page.evaluate("earnedFrom(lives[1], moment.t) < usuallyEarned(lives[1])")


def test_forced_colours_are_followed(opened):
    page = opened(forced_colors="active")
    until(page, "phase === 'ask' && !isMoving")
    assert page.evaluate("colours.ink === getComputedStyle(document.body).color")
    assert page.evaluate(HELD)[0][0] > 0.9
