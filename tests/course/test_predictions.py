"""Predictions: kept, compared with the outcome, and not given away by the notebook that asks for them."""

import json
import re
from pathlib import Path
from typing import Any

import pytest

from rlrobot_course.authoring.lists import lessons
from rlrobot_course.questions.prediction import ASKED, Prediction

ROOT = Path(__file__).parents[2]
NOTEBOOKS = lessons(ROOT)
ANSWERS = ["it falls", "it stays", "it rises"]

Cell = dict[str, Any]


def cells_of(number: str) -> list[Cell]:
    """The cells of a lesson's notebook, the source of each as one text."""
    cells = json.loads(NOTEBOOKS[number].read_text(encoding="utf-8"))["cells"]
    return [cell | {"source": "".join(cell["source"])} for cell in cells]


def predictions_of(
    number: str,
) -> tuple[list[Prediction], list[tuple[Prediction, Cell]]]:
    """Those that a notebook asks for; and those of which it tells the outcome, each with the cell that does so."""
    asked, told, names = [], [], {}
    for cell in cells_of(number):
        source = cell["source"]
        if cell["cell_type"] == "code" and "Prediction(" in source:
            exec(
                source, names
            )  # such a cell does nothing else, and its last line shows the prediction
            asked.append(names[source.splitlines()[-1]])
        told += [
            (names[variable], cell)
            for variable in re.findall(r"^(\w+)\.outcome\(", source, re.MULTILINE)
        ]
    return asked, told


def outcomes_of(number: str) -> dict[str, dict[str, str]]:
    return {
        name: told
        for name, told in ASKED["prediction"].items()
        if name.split()[0] == number
    }


@pytest.mark.parametrize("number", NOTEBOOKS)
def test_no_source_of_a_notebook_gives_an_outcome_away(number):
    for cell in cells_of(number):
        source = cell["source"]
        assert source.count(".outcome(") == source.count(".outcome()"), source
        for told in outcomes_of(number).values():
            assert told["why"] not in source, source


@pytest.mark.parametrize("number", NOTEBOOKS)
def test_every_prediction_is_asked_for_and_told_once_and_has_an_outcome(number):
    asked, told = predictions_of(number)
    assert [prediction.name for prediction in asked] == list(outcomes_of(number))
    assert [prediction for prediction, _ in told] == asked


@pytest.mark.parametrize("number", NOTEBOOKS)
def test_the_outcome_is_one_of_the_answers_and_is_what_the_notebook_has_saved(number):
    for prediction, cell in predictions_of(number)[1]:
        outcome = prediction.outcome()
        assert outcomes_of(number)[prediction.name]["answer"] in prediction.answers
        assert "".join(cell["outputs"][-1]["data"]["text/plain"]) == repr(outcome)


def test_a_prediction_is_kept_and_its_outcome_told(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("rlrobot_course.questions.prediction.is_notebook", lambda: True)
    guess = Prediction("03 turn", "What does Q do?", ANSWERS)
    assert "it rises" in guess.outcome().text and "rises" not in guess._told.value
    guess.choose("it stays")
    assert "it stays" in guess._told.value
    verdict = guess.outcome()
    assert (
        verdict.status == "outcome"
        and "“it rises”" in verdict.text
        and "“it stays”" in verdict.text
    )
    guess.choose("it rises")
    again = Prediction("03 turn", "What does Q do?", ANSWERS)
    assert again.chosen == "it rises" and again.outcome()
    with pytest.raises(ValueError, match="has no answer 'x', only it falls"):
        guess.choose("x")


def test_a_prediction_reads_as_text_where_nothing_runs():
    guess = Prediction("x", "Is 1 < 2?", ["yes & always", "no"])
    shown = guess._repr_mimebundle_()
    assert len(shown["text/plain"].splitlines()) == 3
    assert (
        "Is 1 &lt; 2?" in shown["text/html"]
        and "yes &amp; always" in shown["text/html"]
    )
    assert "application/vnd.jupyter.widget-view+json" in shown


def test_a_prediction_of_which_no_outcome_is_known_says_what_to_do():
    with pytest.raises(
        ValueError,
        match=r"questions\.toml tells no outcome of the prediction '03 alfa'",
    ):
        Prediction("03 alfa", "Which?", ANSWERS).outcome()


def test_an_outcome_that_is_none_of_the_answers_is_an_error():
    with pytest.raises(
        ValueError,
        match="the prediction 03 turn has no answer 'it rises', only yes, no",
    ):
        Prediction("03 turn", "Will it come to rest?", ["yes", "no"]).outcome()
