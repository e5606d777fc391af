"""The bins of five readings."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

bins = (1, 2, 3, 0, 3)

exercise = Question(
    task="five bins as a tuple, such as (0, 1, 2, 3, 0)",
    right=bins,
    because="0.53 lies exactly on a cut, and belongs to the bin below it, 0.54 to the one above. All beyond 0.80 m is "
    "bin 3, whether 0.9 or 5.",
    mistakes={
        "cut_at_0_53": Mistake("0.53 m lies exactly on a cut: x ≤ 0.53 is still bin 1.", (2, 2, 3, 0, 3)),
        "cut_at_0_27": Mistake("0.27 m lies exactly on a cut: x ≤ 0.27 is still bin 0.", (1, 2, 3, 1, 3)),
        "both_cuts": Mistake(
            "a reading exactly on a cut belongs to the bin below it. Two of the five do.", (2, 2, 3, 1, 3)
        ),
        "counts_from_1": Mistake("bins are counted from 0: the nearest is bin 0.", (2, 3, 4, 1, 4)),
        "counts_from_1_and_both_cuts": Mistake(
            "bins are counted from 0, and a reading on a cut belongs to the bin below it.", (3, 3, 4, 2, 4)
        ),
        "above_0_53": Mistake("0.54 m is more than the cut at 0.53 m: one bin further.", (1, 1, 3, 0, 3)),
        "above_0_80": Mistake("0.90 m is beyond the last cut, 0.80 m. That is the last bin, bin 3.", (1, 2, 3, 0, 2)),
        "bin_4": Mistake("2.10 m is beyond the last cut, 0.80 m: bin 3. There is no bin 4.", (1, 2, 4, 0, 3)),
        "inverted": Mistake("near is bin 0, far is bin 3: yours are the other way round.", (2, 1, 0, 3, 0)),
        "readings": Mistake("these are the readings. How many cuts lie below each?", (0.53, 0.54, 2.10, 0.27, 0.90)),
    },
    hints=(
        "How many of the three cuts lie below the reading? That is the number of its bin.",
        "Below 0.53 lies one cut, 0.27 (0.53 itself does not lie below 0.53). So the first is bin 1.",
        "(1, 2, …, 0, …), and the two that are missing lie beyond all cuts.",
    ),
    gained="You can read the rings: what the robot is told of five numbers in metres is five small whole numbers.",
    witnesses={
        "cut_at_0_53": [(2, 2, 3, 0, 3)],
        "counts_from_1": [[2, 3, 4, 1, 4]],
        "above_0_53": [(1, 1, 3, 0, 3)],
        "bin_4": [(1, 2, 4, 0, 3)],
        "inverted": [(2, 1, 0, 3, 0)],
    },
)
