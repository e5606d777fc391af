"""Films side by side run together, step by step, and each says whose it is."""

import io

from PIL import Image

import rlrobot_edu as rl
from rlrobot_course.figures.plots import SideBySide


def filmed(steps):
    agent, env = (
        rl.Agent("wander_simple", "SL+SR", seed=0),
        rl.make_env("wander_simple", seed=0),
    )
    return rl.film(agent, env, steps=steps)


def test_films_side_by_side_are_one_film_as_long_as_the_shorter_of_them():
    films = {"left": filmed(3), "right": filmed(2)}
    shown = SideBySide(films)
    still = shown.still()
    both, one = (
        Image.open(io.BytesIO(data)) for data in (still.data, films["left"].gif())
    )
    assert shown.widget is None and still.mime == "image/gif"
    assert (both.n_frames, both.width, both.height) == (2, 2 * one.width, one.height)
    assert "left, at the end: " in still.alt and "right, at the end: " in still.alt
