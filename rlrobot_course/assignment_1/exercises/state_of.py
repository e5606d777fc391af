"""The number of a state from a cell and a voltage."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.replay import Case


def state_of(cell, voltage, cuts):
    charge = sum(voltage > cut for cut in cuts)
    return cell * (len(cuts) + 1) + charge


VOLTS = [11.25, 11.75, 12.25]


def other_cell(rng: np.random.Generator, case: Case) -> Case:
    """A case of `state_of` in another cell, its voltages moved; what lies on a cut stays there."""
    volts = float(rng.uniform(-0.9, 0.9))
    cuts = [cut + volts for cut in case["cuts"]]
    return {"cell": case["cell"] + int(rng.integers(1, 4)), "voltage": case["voltage"] + volts, "cuts": cuts}


WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return the number of the state: the cell counts most, the bin of the voltage least",
    right=state_of,
    returns="state",
    tape=[
        {"cell": 0, "voltage": 11.0, "cuts": VOLTS},
        {"cell": 0, "voltage": 12.0, "cuts": VOLTS},
        {"cell": 2, "voltage": 12.5, "cuts": VOLTS},
        {"cell": 1, "voltage": 11.75, "cuts": VOLTS},
        {"cell": 5, "voltage": 11.5, "cuts": [11.25]},
        {"cell": 3, "voltage": 13.0, "cuts": [11.0, 11.5, 12.0, 12.5, 13.5]},
        {"cell": 1, "voltage": 9.0, "cuts": VOLTS},
    ],
    mistakes={
        "as_many_bins_as_cuts": Mistake(
            "k cuts make k + 1 bins, so each cell has k + 1 states. Yours have k, and two states share a number.",
            {"(len(cuts) + 1)": "len(cuts)"},
        ),
        "on_the_cut": Mistake(
            "on a cut point counts as below it: a bin ends with its cut. Compare with >.",
            {"voltage > cut": "voltage >= cut"},
        ),
        "inverted": Mistake(
            "the bins are the wrong way round: the bin is how many cuts lie below the voltage.",
            {"voltage > cut": "voltage <= cut"},
        ),
        "counts_from_1": Mistake(
            "bins are numbered from 0: below all cuts is bin 0.", {"for cut in cuts)": "for cut in cuts) + 1"}
        ),
        "only_added": Mistake(
            "cell and bin are only added, so many pairs share a number. Each cell needs a block of states.",
            {"cell * (len(cuts) + 1)": "cell"},
        ),
        "no_cell": Mistake(
            "the cell is missing: the same voltage in another cell is another state.",
            {"cell * (len(cuts) + 1) + charge": "charge"},
        ),
        "bin_first": Mistake(
            "here the bin counts most. The cell should: cell times the number of bins, plus the bin.",
            {"cell * (len(cuts) + 1) + charge": "charge * (len(cuts) + 1) + cell"},
        ),
        "adds_voltages": Mistake(
            "the sum adds voltages up. Count the cuts that lie below the voltage.",
            {"voltage > cut for": "cut * (voltage > cut) for"},
        ),
        "no_bin": Mistake("the bin is missing: the same cell with another charge is another state.", {" + charge": ""}),
    },
    another=other_cell,
    hints=(
        "First the bin: how many cuts lie below the voltage? Then the number: how many states has each cell?",
        "k cuts make k + 1 bins. A cell is a block of k + 1 states, one for each bin: the cell's number times k + 1.",
        "charge = sum(voltage > cut for cut in cuts), and then cell * (len(cuts) + 1) + …",
    ),
    gained="Two readings, one number: from here on the cart is a row of a table. The last exercise learns in it.",
    witnesses=WITNESSES,
)
