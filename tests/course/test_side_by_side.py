"""Films side by side run together, step by step, and each says whose it is."""

import io

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
    assert "left, at the end: " in still.alt and "right, at the end: " in still.alt
