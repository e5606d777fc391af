"""Films side by side run together, step by step, and each says whose it is."""

import io
import re
from html import escape

import numpy as np
from PIL import Image, ImageSequence

import rlrobot_edu as rl
from rlrobot_course.figures.plots import ROW, SideBySide


def filmed(steps):
    agent, env = (
        rl.Agent("wander_simple", "SL+SR", seed=0),
        rl.make_env("wander_simple", seed=0),
    )
    return rl.film(agent, env, steps=steps)


def test_films_side_by_side_are_one_film_in_which_the_shorter_waits_at_its_end():
    films = {"left": filmed(3), "right": filmed(2)}
    shown = SideBySide(films)
    still = shown.still()
    both = Image.open(io.BytesIO(still.data))
    assert shown.widget is None and still.mime == "image/gif"
    assert (both.n_frames, both.width) == (3, ROW)
    lefts, rights = [], []
    for picture in ImageSequence.Iterator(both):
        seen = np.asarray(picture.convert("RGB"))
        lefts.append(seen[:, : ROW // 2])
        rights.append(seen[:, ROW // 2 :])
    assert not np.array_equal(lefts[1], lefts[2])
    assert np.array_equal(rights[1], rights[2])
    for name, film in films.items():
        assert f"{name}: {film.finding}. At the end: " in still.alt


def test_above_each_film_stand_its_name_and_its_finding_in_readable_letters():
    films = {"at <random>": filmed(3), "right": filmed(2)}
    page = SideBySide(films)._as_html()
    captions = re.findall(r"<td style=\"(.*?)\"><strong>(.*?)</strong><br>(.*?)</td>", page)  # fmt: skip
    assert [(name, said) for _, name, said in captions] == [
        (escape(name), film.finding) for name, film in films.items()
    ]
    assert all("font-size: 14px" in style for style, _, _ in captions)
    assert page.index("</table>") < page.index("<img")


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
