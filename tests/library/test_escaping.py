"""Text from outside is shown as it stands, wherever it lands: it adds no tag, no formula, no column and no line."""

from __future__ import annotations

import dataclasses
import html
import io
import json
import string
import warnings
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from in_markdown import in_markdown
from in_node import explored, view
from matplotlib import cbook
from matplotlib.figure import Figure
from matplotlib.text import Text
from worlds import small_source

import rlrobot_edu as rl
from rlrobot_course.lesson_01.figures import plot_bins
from rlrobot_course.lesson_03.figures import plot_one_value
from rlrobot_course.lesson_07.figures import plot_corridor
from rlrobot_course.lesson_09.figures import plot_pull, plot_worth
from rlrobot_course.lesson_13.many import Bounds, plot_many
from rlrobot_course.lesson_15.figures import plot_shuffled
from rlrobot_course.play.challenge import Score
from rlrobot_edu.experiments.tables import Table
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.recording import Recording
from rlrobot_edu.models.source import Source
from rlrobot_edu.show.in3d.visualizer import show_scene
from rlrobot_edu.show.in3d.window import Window
from rlrobot_edu.show.picture import plain
from rlrobot_edu.show.top_down import plot_scene
from rlrobot_edu.task.spaces import ActionSpace, StateSpace
from rlrobot_edu.widgets.bias_explorer.explorer import BiasExplorer

NASTY = (
    "<script>alert(\"é & 'x'\")</script>\n_a_ $\\nope$ |`b` *c* ]]> <!-- [d](e) &lt; \\"
)
SHORT = ("<b>&$|$", "_mine", "*`'\"\\")  # short enough to head a column


def tame(text: str) -> str:
    """As long and of as many lines, but of letters only."""
    return "".join(sign if sign == "\n" else "x" for sign in text)


class Parsed(HTMLParser):
    """The tags of a page with the names of their attributes, and all that a reader can come to see."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, tuple[str, ...]]] = []
        self.words: list[str] = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, tuple(name for name, _ in attrs)))
        self.words += [value or "" for _, value in attrs]

    def handle_endtag(self, tag):
        self.tags.append((f"/{tag}", ()))

    def handle_data(self, data):
        self.words.append(data)

    def handle_comment(self, data):
        self.tags.append(("comment", ()))

    def unknown_decl(self, data):
        self.tags.append(("declaration", ()))


def same_page(nasty: str, calm: str, *texts: str) -> None:
    """Two pages have the same tags, and one of them says these texts, sign for sign."""
    one, other = Parsed(nasty), Parsed(calm)
    assert one.tags == other.tags
    for text in texts:
        assert any(text in words for words in one.words), text


def drawn(figure: Figure) -> list[str]:
    """All texts of a figure as they are drawn, which must go without an error or a warning."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        figure.savefig(io.BytesIO(), format="png", dpi=40)
    texts = [text.get_text() for text in figure.findobj(Text) if text.get_visible()]
    formulas = [
        text for text in texts if cbook.is_math_text(text) and "mathdefault" not in text
    ]
    assert not formulas
    return [text.replace(r"\$", "$") for text in texts]


def says(figure: Figure, *texts: str) -> None:
    """Each of these texts is drawn, sign for sign."""
    there = drawn(figure)
    for text in texts:
        assert any(text in one for one in there), (text, there)


def task_with(names) -> rl.Task:
    """The worked example with a name, a description, an output and words of another's choice."""
    task = rl.load_task("worked_example")
    name, *words = names
    move = rl.OutputVariable(name, values=[0, 1, 2], words=words)
    own = task.command
    return dataclasses.replace(
        task,
        name=name,
        description=name,
        outputs=[move],
        command=lambda values: own({"move": values[name]}),
    )


@pytest.fixture(scope="module")
def tasks():
    return [
        task_with(names)
        for names in ((NASTY, *SHORT), (tame(NASTY), *map(tame, SHORT)))
    ]


@pytest.fixture(scope="module")
def long_words():
    names = (NASTY, NASTY + "1", "_" + NASTY, NASTY + "3")
    return [task_with(names), task_with(tuple(map(tame, names)))]


def steppers(tasks, method="TOSL+QBIASSR"):
    return [
        rl.Stepper(rl.Agent(task, method, seed=0), rl.make_env(task, seed=0), at=3)
        for task in tasks
    ]


@pytest.mark.long
def test_a_stepper_shows_names_and_words_as_they_stand(tasks, long_words):
    for few, texts in ((tasks, SHORT), (long_words, [NASTY + "1"])):
        nasty, calm = steppers(few)
        same_page(view(nasty), view(calm), *texts)
        says(nasty.picture(), *texts)
        data = nasty._repr_mimebundle_()
        json.dumps(
            {key: value for key, value in data.items() if isinstance(value, str)}
        )
    same_page(*map(view, steppers(tasks, "Q+EG")))


def test_a_bias_explorer_shows_names_and_words_as_they_stand(tasks, long_words):
    for few, texts in ((tasks, SHORT), (long_words, [NASTY])):
        q = np.random.default_rng(0).normal(size=(24, 3))
        nasty, calm = (
            BiasExplorer(task, {task.name: q, "_mine": q}, state=21) for task in few
        )
        same_page(*(explored(each)[21]["html"] for each in (nasty, calm)), *texts)
        says(nasty.picture(), *texts)
        assert all(text in nasty.picture().alt for text in texts)
        nasty._repr_mimebundle_()


def history(seed: int = 0):
    agent = rl.Agent("worked_example", "Q+SR", seed=seed)
    return rl.learn(agent, rl.make_env("worked_example", seed=seed), 60, progress=False)


LABELS = (NASTY, "_mine", "$x$", "a\nb")


def legend_of(figure: Figure) -> list[str]:
    legends = [
        *figure.legends,
        *(ax.get_legend() for ax in figure.axes if ax.get_legend()),
    ]
    return [
        text.get_text().replace(r"\$", "$")
        for legend in legends
        for text in legend.get_texts()
    ]


@pytest.mark.parametrize("own_axes", [False, True])
def test_learning_curves_name_every_curve_in_the_legend(own_axes):
    figure = Figure()
    options = {"ax": figure.add_subplot()} if own_axes else {}
    several = [history(0), history(1)]
    shown = rl.plot_learning(
        *[several] * len(LABELS), labels=LABELS, title=NASTY, **options
    )
    figure = figure if own_axes else shown
    says(figure, NASTY, *LABELS)
    names = legend_of(figure)
    assert len(names) == len(LABELS) and all(
        label in name for label, name in zip(LABELS, names, strict=True)
    )
    if not own_axes:
        assert all(label in shown.still().alt for label in LABELS)


@pytest.fixture(scope="module")
def comparisons(tasks):
    """The same comparison in both tasks, with labels of both kinds."""
    each = []
    for task, labels in zip(
        tasks,
        (LABELS, ["y" * i + tame(label) for i, label in enumerate(LABELS)]),
        strict=True,
    ):
        methods = {label: {"method": "Q+SR"} for label in labels}
        each.append(rl.compare(task, methods, 3, steps=60, n_jobs=1, progress=False))
    return each


def test_a_comparison_draws_its_task_and_all_its_labels(comparisons):
    figure = comparisons[0].plot()
    says(figure, NASTY, *LABELS)
    assert len(legend_of(figure)) == len(LABELS)
    says(comparisons[0].plot(title=NASTY), NASTY)


def test_the_name_of_a_task_file_is_drawn_as_it_stands(tmp_path):
    path = tmp_path / "_$x$ & 'é' `b` [c](d).py"
    path.write_bytes(Path(rl.load_task("worked_example").path).read_bytes())
    result = rl.compare(path, ["Q+SR"], 2, steps=60, n_jobs=1, progress=False)
    says(result.plot(), path.stem)
    plain_name = rl.compare(
        "worked_example", ["Q+SR"], 2, steps=60, n_jobs=1, progress=False
    )
    same_page(
        *(rendered(in_markdown(each.table())) for each in (result, plain_name)),
        path.stem,
    )


def rendered(document: str) -> str:
    mistune = pytest.importorskip("mistune")
    return mistune.create_markdown(escape=False, plugins=["table", "strikethrough"])(
        document
    )


def test_the_tables_of_a_comparison_show_labels_as_they_stand(comparisons):
    nasty, calm = comparisons
    tables = [[one.table(), one.tukey().table()] for one in (nasty, calm)]
    for one, other in zip(*tables, strict=True):
        same_page(one._repr_html_(), other._repr_html_(), NASTY)
        in_a_line = NASTY.replace("\n", " ")
        assert in_markdown(one).count("\n") == in_markdown(other).count("\n")
        same_page(rendered(in_markdown(one)), rendered(in_markdown(other)), in_a_line)
        assert str(one).count("\n") == str(other).count("\n") and in_a_line in str(one)
    assert NASTY in repr(nasty)


SIGNS = "\\`*_|<>&$~[]()!#-+=:;'\"{}/ab1 é\n"


@given(cell=st.text(SIGNS, max_size=20), caption=st.text(SIGNS, max_size=10))
@settings(max_examples=300, deadline=None)
def test_markdown_of_any_text_reads_as_the_text(cell, caption):
    table = Table(f"a{caption}b", ["one", "two"], [[f"a{cell}b", "c"]])
    shown = Parsed(rendered(in_markdown(table)))
    assert [tag for tag, _ in shown.tags if tag.startswith("t")] == [
        "table",
        "thead",
        "tr",
        "th",
        "th",
        "tbody",
        "tr",
        "td",
        "td",
    ]
    words = "".join(shown.words)
    for text in (f"a{cell}b", f"a{caption}b"):
        assert " ".join(text.split()) in " ".join(words.split())


@given(text=st.text(string.printable + "é€$_\\\x00\ud800\u2028", max_size=12))
@settings(max_examples=40, deadline=None)
def test_matplotlib_draws_any_text_as_the_text(text):
    figure = Figure(figsize=(3, 3))
    ax = figure.add_subplot(title=plain(text))
    ax.plot([0, 1], label=plain("_" + text))
    ax.legend()
    seen = "".join(sign if sign.isprintable() or sign == "\n" else " " for sign in text)
    says(figure, seen)
    assert len(legend_of(figure)) == 1 and seen in legend_of(figure)[0]


def test_scenes_are_named_on_pictures_and_pages_as_they_stand():
    scene = rl.make_env("worked_example", seed=0).unwrapped.robot.scene()
    scenes = []
    for name in (NASTY, tame(NASTY)):
        box = scene.solids[-1]._replace(name=name, role="object")
        scenes.append(scene._replace(solids=(*scene.solids, box)))
    says(plot_scene(scenes[0], title=NASTY), NASTY)
    same_page(*(show_scene([each, each], [0.0, 1.0]).html for each in scenes))
    same_page(*(Window(text).page() for text in (NASTY, tame(NASTY))), NASTY)


def nasty_source() -> Source:
    source = small_source()
    states = StateSpace(
        [
            dataclasses.replace(v, name=f"{NASTY}{i}")
            for i, v in enumerate(source.states.inputs)
        ]
    )
    actions = ActionSpace(
        [rl.OutputVariable(NASTY, values=[0, 1], unit=NASTY, words=[NASTY, "_mine"])]
    )
    texts = dict.fromkeys(
        ("task_name", "robot", "scene", "method", "version", "platform"), NASTY
    )
    return dataclasses.replace(source, states=states, actions=actions, **texts)


def test_a_data_package_keeps_every_name_as_it_is(tmp_path):
    s = np.array([0, 1, 2])
    ends = np.zeros(3, dtype=bool)
    recording = Recording(
        Transitions(s, s % 2, np.zeros(3), s + 1, ends, ends), nasty_source()
    )
    assert NASTY in repr(recording)
    recording.save(tmp_path)
    package = json.loads((tmp_path / "datapackage.json").read_text(encoding="utf-8"))
    assert NASTY in package["title"] and set(package["name"]) <= set(
        string.ascii_lowercase + string.digits + "._-"
    )
    assert rl.read_recording(tmp_path).source == recording.source


def test_the_pictures_of_the_lessons_show_labels_and_titles_as_they_stand(tasks):
    rng = np.random.default_rng(0)
    wide = rl.InputVariable(NASTY, cuts=[0.3, 0.6], unit="$m$", low=0.0)
    says(plot_bins([wide], {NASTY: 0.4}), NASTY, "$m$")
    says(
        plot_pull(rng.normal(size=2), rng.normal(size=2), LABELS[:2], 10.0), *LABELS[:2]
    )
    says(
        plot_corridor({NASTY: np.ones((3, 4)), "_mine": np.ones((3, 4))}),
        NASTY,
        "_mine",
    )
    says(
        plot_worth({label: (Score(1.0, 0.1), Score(2.0, 0.1)) for label in LABELS}),
        *LABELS,
    )
    says(
        plot_shuffled({NASTY: rng.normal(size=5), "b": rng.normal(size=5)}, times=50),
        NASTY,
    )
    says(
        plot_many(
            {label: np.ones(2) for label in LABELS}, NASTY, Bounds(0, "low", 1, "high")
        ),
        NASTY,
        *LABELS,
    )
    figure = plot_one_value(tasks[0], 0, 0, {label: {} for label in LABELS}, steps=60)
    says(figure, *LABELS)


def test_what_a_table_of_a_notebook_escapes_is_escaped_once():
    table = Table(NASTY, [NASTY], [[NASTY]])
    assert table._repr_html_().count(html.escape(NASTY)) == 3
