"""Films side by side run together, step by step, and each says whose it is."""

import base64
import io
import re
from dataclasses import replace
from html import escape

from PIL import Image, ImageSequence

import rlrobot_edu as rl
from rlrobot_course.figures.plots import ROW, SideBySide


def filmed(steps):
    agent, env = (
        rl.Agent("wander_simple", "SL+SR", seed=0),
        rl.make_env("wander_simple", seed=0),
    )
    return rl.film(agent, env, steps=steps)


def moving(page):
    """The GIFs of a page."""
    found = re.findall(r"data:image/gif;base64,([^\"]+)", page)
    return [Image.open(io.BytesIO(base64.b64decode(each))) for each in found]


def lasts(gif):
    """How long it plays until it begins again [ms]."""
    return sum(picture.info["duration"] for picture in ImageSequence.Iterator(gif))


def test_of_films_side_by_side_the_shorter_waits_at_its_end():
    films = {"left": filmed(3), "right": filmed(2)}
    shown = SideBySide(films)
    page = shown._as_html()
    left, right = moving(page)
    assert shown.widget is None and shown.still() is None
    assert (left.n_frames, right.n_frames) == (3, 2)
    assert left.width == right.width <= ROW // 2
    assert lasts(left) == lasts(right)
    for film in films.values():
        assert escape(film.told) in page


def test_above_each_film_stand_its_name_and_its_finding_and_their_task_once():
    films = {"at <random>": filmed(3), "right": filmed(2)}
    page = SideBySide(films)._as_html()
    assert page.count("<b>Wander in a small square</b>") == 1
    for name, film in films.items():
        said = film.finding.removeprefix("Wander in a small square: ")
        words = f"<b>{escape(name)}</b>: {said[0].upper()}{said[1:]}"
        assert words in page
        assert page.index(words) < page.index(escape(film.told))
    # films of two tasks have theirs above themselves
    films["right"] = replace(films["right"], task="Park")
    page = SideBySide(films)._as_html()
    assert "Wander in a small square: " in page and "</b>: Park: " in page


def test_a_running_notebook_shows_films_in_3d_where_that_is_asked_for(monkeypatch):
    monkeypatch.setattr("rlrobot_edu.show.film.in_a_notebook", lambda: True)
    monkeypatch.delenv("RLROBOT_EDU_PROGRESS", raising=False)
    films = {"left": filmed(3), "right": filmed(2)}
    assert SideBySide(films).widget is None
    columns = SideBySide(films, in3d=True).widget.children
    for column, (name, film) in zip(columns, films.items(), strict=True):
        said, view = column.children
        assert name in said.value and escape(film.finding) in said.value
        assert view is film.widget
