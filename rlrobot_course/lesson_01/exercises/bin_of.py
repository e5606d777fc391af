"""The number of the bin of a reading."""

from __future__ import annotations

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def bin_of(x, cuts):
    number = 0
    for cut in cuts:
        if x > cut:
            number += 1
    return number


LASER = [0.27, 0.53, 0.80]  # cut points [m]

ANGLE = [-45, 0, 45, 90]  # cut points [deg]

CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="return the number of the bin that the reading x falls into",
    right=bin_of,
    returns="bin",
    tape=[{"x": x, "cuts": LASER} for x in (0.53, 0.70, 0.10, 0.30, 2.00, 0.27, 0.80)]
    + [{"x": x, "cuts": [0.20]} for x in (0.20, 0.21)]
    + [{"x": x, "cuts": ANGLE} for x in (-30, -90, 90, 180, 0, 20)]
    + [{"x": x, "cuts": [1.5, 1.6, 4.0, 4.5, 9.0]} for x in (4.2, 1.55, 5, 9.1)],
    mistakes={
        "on_the_cut": Mistake(
            "a reading exactly on a cut point belongs to the bin below it: x ≤ c₁ is bin 0.", {"x > cut": "x >= cut"}
        ),
        "counts_from_1": Mistake("bins are counted from 0, and yours from 1.", {"number = 0": "number = 1"}),
        "counts_above_and_on": Mistake(
            "these are the cut points above x. The number of the bin is how many lie below it.", {"x > cut": "x <= cut"}
        ),
        "counts_above": Mistake(
            "these are the cut points above x. The number of the bin is how many lie below it.", {"x > cut": "x < cut"}
        ),
        "three_cuts": Mistake(
            "this counts three cut points at most. The list may be longer: go through all of it.",
            {"in cuts": "in cuts[:3]"},
        ),
        "indices_for_cuts": Mistake(
            "x is compared with the numbers 0, 1, 2 …, not with the cut points. Write for cut in cuts, or cuts[i].",
            {"in cuts": "in range(len(cuts))"},
        ),
        "list_of_answers": Mistake(
            "this says yes or no for each cut point. How often is it yes?",
            {"return number": "return [x > cut for cut in cuts]"},
        ),
        "beyond_is_0": Mistake(
            "beyond the last cut point yours gives 0 (argmax does, where nothing is True). It is bin k there.",
            {"return number": "return number % len(cuts)"},
        ),
        "else_sets_back": Mistake(
            "a later cut point above x sets the number back to 0. Leave the else out: begin with 0, and only ever "
            "raise it.",
            CHANGED["else_sets_back"],
        ),
        "last_cut_wins": Mistake(
            "the loop goes on after the bin is found, and a later cut point wins. Return at once.",
            {
                "number = 0": "number = len(cuts)",
                "if x > cut": "if x <= cut",
                "number += 1": "number = cuts.index(cut)",
            },
        ),
        "counts_anew": Mistake(
            "number = 0 stands inside the loop, so the counting begins anew with each cut point.",
            CHANGED["counts_anew"],
        ),
        "one_too_few": Mistake(
            "this is the index of the last cut point below x; the bin's number is one more.",
            {"number = 0": "number = -1"},
        ),
        "first_cut_missing": Mistake(
            "the first cut point does not count here. Is it left out, or is it its index that you return? The "
            "bin's number is how many cut points lie below x.",
            {"in cuts": "in cuts[1:]"},
        ),
        "not_the_last_bin": Mistake(
            "the last bin is missing: k cut points make k + 1 bins, and beyond the last cut is bin k. Do you go "
            "through all cut points?",
            {"return number": "return min(number, len(cuts) - 1)"},
        ),
        "first_cut_alone": Mistake(
            "0 or 1: this tells only whether x lies above the first cut point. Compare x with every one of them, "
            "add 1 each time (number += 1), and return when the loop is over.",
            {"in cuts": "in cuts[:1]"},
        ),
        "cut_above": Mistake(
            "this is a cut point, and what is asked is the number of the bin.",
            {"if x > cut": "if x <= cut", "number += 1": "return cut", "return number": "return cut"},
        ),
        "cut_below": Mistake(
            "this is a cut point, and what is asked is the number of the bin.", {"number += 1": "number = cut"}
        ),
        "cut_of_the_bin": Mistake(
            "this is a cut point, and what is asked is the number of the bin.", {"return number": "return cuts[number]"}
        ),
        "adds_cuts": Mistake(
            "this adds up the cut points below x. Count them: number += 1.", {"number += 1": "number += cut"}
        ),
        "divides": Mistake(
            "the bins are not equally wide, so dividing does not tell which it is. Compare with the cut points.",
            {"return number": "return int(x // cuts[0])"},
        ),
        "nearest_cut": Mistake(
            "this is the cut point nearest to x. Ask how many lie below it.",
            {"return number": "return min(range(len(cuts)), key=lambda i: abs(cuts[i] - x))"},
        ),
        "abs_of_x": Mistake(
            "a reading may be negative, as an angle is. Compare x itself, not abs(x).", {"x > cut": "abs(x) > cut"}
        ),
        "own_cuts": Mistake(
            "every reading is cut at 0.27, 0.53 and 0.80 here. Use the list cuts that the function is given.",
            {"in cuts": "in [0.27, 0.53, 0.80]"},
        ),
        "rounds_x": Mistake(
            "comparing rounded readings moves them into other bins. Compare x as it is.",
            {"x > cut": "round(x, 1) > cut"},
        ),
        "cuts_off_x": Mistake(
            "comparing rounded readings moves them into other bins. Compare x as it is.", {"x > cut": "int(x) > cut"}
        ),
        "rounds_both": Mistake(
            "comparing rounded readings moves them into other bins. Compare x as it is.",
            {"x > cut": "round(x, 1) > round(cut, 1)"},
        ),
        "index_one_too_many": Mistake(
            "the last bin's number is len(cuts), 1 more than the index of the last cut point.",
            {"return number": "return number if number < len(cuts) else len(cuts) + 1"},
        ),
    },
    hints=(
        "For x = 0.30 and the cuts 0.27, 0.53, 0.80 only one cut point lies below x. So the bin is 1.",
        "Begin with number = 0, go through the cut points with a loop, and add 1 for each that is smaller than x.",
        "for cut in cuts: if x > cut: number += 1. After the loop: return number.",
    ),
    gained="You have given a robot its eyes: from now on, every reading in this course goes through these few lines.",
    witnesses=WITNESSES,
)
