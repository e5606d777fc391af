"""The last page of the course: what the model promised, the simulator paid, and the robot earned over the link."""

from collections.abc import Mapping
from html import escape
from itertools import pairwise
from math import hypot
from pathlib import Path
from string import Template

import numpy as np

from rlrobot_course.figures.plots import Picture
from rlrobot_course.figures.rows import Rows
from rlrobot_course.figures.runs import mean_and_half
from rlrobot_course.learner.learners_files import beside_the_lessons
from rlrobot_course.thread.numbers import STEPS, STRETCHES, signed
from rlrobot_course.thread.rows import FOLDER, whose
from rlrobot_edu import Recording
from rlrobot_edu.files import write_whole
from rlrobot_edu.show.palette import DARK, LIGHT

NOTE = f"reward a step; a dot: one of {STRETCHES} stretches of {STEPS} steps, line: their mean, band: its 95 % interval"
WHERE = {"promised": "in the model", "simulated": "in the simulator", "driven": "over the link"}  # fmt: skip

Found = Mapping[str, np.ndarray]  # "promised", "simulated", "driven": arrays (10,)


def difference(more: np.ndarray, less: np.ndarray) -> tuple[float, float]:
    """How much more the first earns, and half of the 95 % interval of that: about, for stretches of one drive."""
    high, its_half = mean_and_half(more)
    low, other_half = mean_and_half(less)
    return high - low, hypot(its_half, other_half)


def compared(found: Found, one: str, other: str) -> str:
    """Whether the first of two numbers is larger, as a part of a sentence."""
    by, half = difference(found[one], found[other])
    numbers = f"{signed(by)} ± {signed(half)}"
    if by > half:
        return f"{one} is more than {other}, by {numbers}"
    if by < -half:
        return f"{one} is less than {other}, by {signed(-by)} ± {signed(half)}"
    return f"{one} and {other} are not shown to differ ({numbers})"


def sentence(found: Found) -> str:
    """What the differences say, in a sentence; of two numbers or of three."""
    names = list(found)
    said = "; ".join(compared(found, one, other) for one, other in pairwise(names))
    return said[0].upper() + said[1:]


def plot_numbers(found: Found) -> Picture:
    """The numbers, each with its stretches and its interval; the last one is the hero."""
    hero = list(found)[-1]
    finding = "; ".join(
        f"{name} {signed(values.mean())}" for name, values in found.items()
    )
    rows = Rows(found, f"Your robot: {finding}", NOTE, hero=hero)
    told = []
    for name in found:
        rows.dots(name)
        told.append(f"{name}: {rows.mean(name)}")
    rows.picture.alt = f"Reward a step of one agent, means with 95 % intervals. {'; '.join(told)}. {sentence(found)}."
    return rows.picture


def keep_page(found: Found, rows: Recording, folder: str | Path = FOLDER) -> Picture:
    """Write the last page, `my_robot.html`, whole or not at all; returns its picture, and prints its sentence."""
    picture = plot_numbers(found)
    still = picture.still()
    table = []
    for name, values in found.items():
        mean, half = mean_and_half(values)
        table.append(
            f"<tr><th>{name}<td>{signed(mean)} ± {signed(half)}<td>{WHERE[name]}"
        )
    text = PAGE.substitute(
        picture=still.html,
        table="\n".join(table),
        sentence=escape(sentence(found)),
        whose=escape(whose(rows)),
        stretches=STRETCHES,
        steps=STEPS,
        **{f"light_{name}": LIGHT[name] for name in ("paper", "ink")},
        **{f"dark_{name}": DARK[name] for name in ("paper", "ink")},
    )
    write_whole(beside_the_lessons(folder) / "my_robot.html", text)
    print(f"{sentence(found)}.\nThe page is kept: {folder}/my_robot.html")
    return picture


PAGE = Template("""<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>My robot: promised, simulated, driven</title>
<style>
:root { color-scheme: light dark; background: $light_paper; color: $light_ink }
@media (prefers-color-scheme: dark) { :root { background: $dark_paper; color: $dark_ink } }
body { max-width: 48rem; margin: 2rem auto; padding: 0 1rem; font: 1.05rem/1.5 system-ui, sans-serif }
th, td { text-align: left; padding-right: 1.5rem }
td:first-of-type { white-space: nowrap }
caption { text-align: left }
img { max-width: 100%; height: auto }
</style>
<h1>My robot: promised, simulated, driven</h1>
<p>It learned from $whose, in a model of these rows alone.
<table>
<caption>reward a step, with the 95 % interval of the mean</caption>
$table
</table>
<p><strong>$sentence.</strong>
<p>$picture
<p>Each number is the mean of $stretches stretches of $steps steps. They follow each other in one drive, so the
intervals are rough: they say nothing of other rooms, other rows or other agents.
</html>
""")
