"""Lesson 07's figures: how far a reward has spread, and what robots earn with each λ."""

import csv
from pathlib import Path

import numpy as np

from rlrobot_course.lesson_07.figures import (
    EARLY,
    EARNED,
    HOUR,
    LAMBDAS,
    best_lambda,
    plot_corridor,
    plot_lambdas,
)


def test_the_picture_of_the_corridor_shows_every_value_and_says_how_far_it_got():
    table = np.array([[0.0, 0.0, 9.0], [0.0, 8.1, 9.0]])
    picture = plot_corridor({"SARSA": table, "SARSA(λ)": table + 1})
    assert picture.finding == (
        "The reward reaches the first cell with SARSA not in 2 drives, with SARSA(λ) in 1 drive"
    )
    table[1, 0] = 7.0
    assert plot_corridor({"SARSA": table}).finding.endswith("with SARSA in 2 drives")
    assert [len(ax.texts) for ax in picture.axes] == [6, 6]


def test_the_figure_of_the_lambdas_shows_what_was_computed():
    path = Path(__file__).parents[2] / "studies" / "lesson_numbers.csv"
    with path.open(encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["lesson"] == "07"]
    computed = {
        (row["of"], row["steps"]): (float(row["value"]), float(row["half_interval"]))
        for row in rows
    }
    shown = {
        (f"λ = {lam}, {world}", steps): number
        for world, times in EARNED.items()
        for when, steps in ((EARLY, "1000"), (HOUR, "3600"))
        for lam, number in zip(LAMBDAS, times[when], strict=True)
    }
    assert shown == computed
    assert plot_lambdas().alt.count("±") == 12


def test_the_title_names_a_best_lambda_only_where_it_shows():
    assert best_lambda(EARNED) == (
        "After an hour λ = 0.9 earns most where walls hold; it is too close to tell where walls slide"
    )
    clear = {"walls hold": {HOUR: ((3.0, 0.1), (2.0, 0.1), (1.0, 0.1))}}
    assert best_lambda(clear) == "After an hour λ = 0 earns most where walls hold"
