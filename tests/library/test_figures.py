"""How figures look: one list of colours, a finding above, names at the ends of curves, letters that can be read."""

import re
from pathlib import Path
from types import SimpleNamespace

import matplotlib as mpl
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.figure import Figure
from PIL import Image, ImageColor

import rlrobot_edu as rl
from rlrobot_edu.show.curves import finding, plot_curves
from rlrobot_edu.show.ends import apart
from rlrobot_edu.show.images import image_of, in_few_colours
from rlrobot_edu.show.palette import BLUE, DARK, GREEN, GREY, LIGHT, RED
from rlrobot_edu.show.picture import Picture
from rlrobot_edu.widgets.bias_explorer.marks import MARKS
from rlrobot_edu.widgets.sliders import ParameterSliders, compared
from rlrobot_grading.exercises import verdict

ROOT = Path(rl.__file__).parents[1]
# Letters in these colours stand on the paper, the back of a page, or the floor.
READ = ("ink", "faint", "blue", "red", "green", "purple")


def luminance(colour: str) -> float:
    """Relative luminance of a colour (WCAG 2.2)."""
    parts = np.array(ImageColor.getrgb(colour)) / 255
    linear = np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
    return float(linear @ [0.2126, 0.7152, 0.0722])


def contrast(a: str, b: str) -> float:
    """Contrast of two colours (WCAG 2.2)."""
    darker, lighter = sorted([luminance(a), luminance(b)])
    return (lighter + 0.05) / (darker + 0.05)


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=["light", "dark"])
def test_letters_can_be_read_in_the_colours_for_letters(theme):
    for name in READ:
        assert contrast(theme[name], theme["paper"]) >= 4.5, name
        assert contrast(theme[name], theme["floor"]) >= 4, name


def test_both_themes_have_the_same_names():
    assert LIGHT.keys() == DARK.keys()


def test_a_check_has_the_colours_of_the_figures():
    own = verdict.BLUE, verdict.GREEN, verdict.GREY, verdict.RED
    assert own == (BLUE, GREEN, GREY, RED)


def test_a_learners_own_figures_keep_matplotlibs_settings():
    before = dict(mpl.rcParams)
    picture = Picture((3, 2))
    picture.subplots().plot([1, 2])
    picture.headline("A finding", "what is plotted")
    picture.png()
    assert dict(mpl.rcParams) == before
    ax = Figure().subplots()
    assert ax.spines["top"].get_visible()


def test_a_flat_area_keeps_its_colour_in_the_file():
    picture = Picture((3, 2))
    ax = picture.subplots()
    shades = np.linspace(0, 1, 400).reshape(20, 20)
    ax.imshow(shades, cmap="cividis")
    ax.axhspan(0, 5, color=LIGHT["red"])
    colours = image_of(picture.still().data).getcolors(10**6)
    assert {ImageColor.getrgb(LIGHT["red"]), (255, 255, 255)} <= {c for _, c in colours}


def test_an_image_of_the_palettes_colours_alone_is_not_changed():
    image = Image.new("RGB", (30, 10), LIGHT["floor"])
    image.paste(LIGHT["wall"], (0, 0, 10, 10))
    image.paste(LIGHT["blue"], (10, 0, 20, 10))
    few = in_few_colours(image, 16).convert("RGB")
    assert few.tobytes() == image.tobytes()


def test_a_long_finding_is_broken_into_lines_that_fit():
    picture = Picture((4, 3))
    picture.subplots()
    picture.headline("A robot that is held by walls " * 4, "a note that is long " * 6)
    picture.draw_without_rendering()
    width = picture.bbox.width
    for text in picture.texts:
        assert "\n" in text.get_text()
        assert text.get_window_extent().x1 <= width
    lowest = min(text.get_window_extent().y0 for text in picture.texts)
    assert picture.axes[0].get_window_extent().y1 < lowest


@given(
    st.lists(st.floats(0, 400), min_size=1, max_size=7),
    st.lists(st.floats(10, 40), min_size=7, max_size=7),
)
def test_names_at_the_ends_do_not_lie_over_each_other(y, heights):
    y = np.sort(np.array(y))
    heights = np.array(heights[: len(y)])
    places = apart(y, heights)
    least = (heights[:-1] + heights[1:]) / 2
    assert (np.diff(places) >= least - 1.0).all()
    assert places.mean() == pytest.approx(y.mean())


def test_the_title_of_curves_says_who_is_ahead_only_where_it_shows():
    rng = np.random.default_rng(0)
    low = rng.normal(1.0, 0.1, (10, 5))
    high = rng.normal(2.0, 0.1, (10, 5))
    wide = rng.normal(1.5, 2.0, (10, 5))
    assert finding([("A", low), ("B", high)]).startswith("B earns most")
    assert finding([("A", wide), ("B", high)]).startswith("Too close to tell")
    assert finding([("A", np.full((10, 5), -1.0))]) == "A earns −1.00 a step"
    assert finding([("A", low[:1]), ("B", high[:1])]).startswith(
        "B earns most in this run"
    )
    assert finding([("A", low)]) == f"A earns {low[:, -1].mean():.2f} a step"


def colours_of(**ends: float) -> dict[str, str]:
    """The colours of curves that end so high."""
    curves = [(name, np.full((2, 5), end)) for name, end in ends.items()]
    axes = plot_curves(curves, "step", None, None).axes[0]
    found = {}
    for line in axes.lines:
        name, says_how_many, _ = str(line.get_label()).partition(" (2 repetitions")
        if says_how_many:  # dots at the ends have no name
            found[name] = str(line.get_color())
    return found


def test_the_hero_of_two_curves_is_blue_and_the_other_grey():
    yours = colours_of(**{"SARSA": 3.0, "SARSA(λ)": 1.0})
    assert yours == {"SARSA": GREY, "SARSA(λ)": BLUE}
    assert colours_of(**{"Q+SR": 3.0, "Q+QBIASSR": 1.0})["Q+QBIASSR"] == BLUE
    both = colours_of(**{"TOSL+QBIASSR": 1.0, "yours": 2.0})
    assert both == {"TOSL+QBIASSR": GREY, "yours": BLUE}


def test_without_a_hero_the_best_curve_is_blue():
    assert colours_of(a=1.0, b=2.0) == {"a": GREY, "b": BLUE}
    assert colours_of(a=1.0, b=2.0, c=0.0)["b"] == BLUE


def test_no_figure_has_a_map_of_colours_of_its_own():
    for folder in ("rlrobot_edu", "rlrobot_course", "studies"):
        for file in (ROOT / folder).rglob("*.py"):
            code = file.read_text(encoding="utf-8")
            assert not re.search(r"cmap[\"']?[=:] ?[\"']", code), file.name


def test_pages_have_no_colours_of_their_own():
    allowed = {colour.lower() for colour in [*LIGHT.values(), *DARK.values()]}
    pages = [*(ROOT / "rlrobot_edu/widgets").rglob("*.css")]
    pages += [*(ROOT / "rlrobot_edu/show/in3d").glob("*.[jh][st]*")]
    assert len(pages) > 4
    for page in pages:
        found = re.findall(r"#[0-9a-fA-F]{6}\b", page.read_text(encoding="utf-8"))
        assert {colour.lower() for colour in found} <= allowed, page.name


def test_a_sign_can_be_read_on_the_colour_of_its_input():
    for mark in MARKS:
        for theme in LIGHT, DARK:  # of a sign, WCAG asks for less than of letters
            assert contrast(theme[mark.token], theme["on-input"]) >= 3, mark


def test_every_robot_s_dot_lies_within_the_chart():
    steps = np.linspace(0, 1, 300)
    repetitions = np.array([0.1, 0.2, 0.1, 9.0, 0.2])[:, None] * steps
    shown = plot_curves([("A", repetitions)], "step", None, None)
    low, high = shown.axes[0].get_ylim()
    assert low <= repetitions[:, -1].min() and repetitions[:, -1].max() <= high


def test_the_sliders_say_more_or_less_only_where_it_can_be_told():
    model = rl.SampleModel.from_recording(rl.read_recording("worked_example"))
    sliders = ParameterSliders(model, "Q+EG", ["alpha"], steps=300, repetitions=4)
    picture = sliders.picture(alpha=0.1)
    assert "earns what it earns with the defaults" in picture.finding
    assert picture.axes[0].get_ylim()[0] <= 0
    assert "yours: α 0.1 ends" in picture.alt

    low, high = (
        SimpleNamespace(curves=np.array([[x], [x + 1.0]])) for x in (0.0, 99.0)
    )
    assert compared(low, high, "α 1").endswith(
        "99.00 a step less than with the defaults"
    )
    assert compared(high, low, "α 1").endswith(
        "99.00 a step more than with the defaults"
    )
    close = SimpleNamespace(curves=np.array([[0.1], [1.2]]))
    assert "too close to tell" in compared(low, close, "α 1")
