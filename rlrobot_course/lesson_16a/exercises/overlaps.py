"""What share of a bin lies in each bin of another ruler."""

from __future__ import annotations

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def overlaps(left, right, edges):
    shares = []
    for i in range(len(edges) - 1):
        low, high = edges[i], edges[i + 1]
        common = min(right, high) - max(left, low)
        shares.append(max(0, common) / (right - left))
    return shares


SHARE = "max(0, common) / (right - left)"

APPEND = f"shares.append({SHARE})"

PIONEER, GIRAFF = [0.0, 0.27, 0.53, 0.80, 5.0], [0.0, 0.08, 0.17, 0.25, 5.0]

CASES = (
    (0.2, 0.4, PIONEER),
    (0.0, 0.2, PIONEER),
    (0.08, 0.17, PIONEER),
    (0.6, 0.8, PIONEER),
    (0.25, 5.0, PIONEER),
    (0.27, 0.53, GIRAFF),
    (0.5, 1.5, [0.0, 1.0, 2.0]),
    (0.27, 0.53, PIONEER),
    (0.1, 0.9, PIONEER),
    (2.0, 6.0, [0.0, 1.0, 3.0, 4.0, 8.0]),
)

CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="return for every bin of the source which part of the interval from left to right lies in it",
    right=overlaps,
    returns="shares",
    tape=[{"left": left, "right": right, "edges": edges} for left, right, edges in CASES],
    mistakes={
        "negative": Mistake(
            "where two intervals do not meet, right end less left end is negative. Such a bin gets 0.",
            {"max(0, common)": "common"},
        ),
        "abs": Mistake(
            "where two intervals do not meet, they share nothing: abs makes something of it. Such a bin gets 0.",
            {"max(0, common)": "abs(common)"},
        ),
        "in_metres": Mistake(
            "these are lengths in metres. A share is the length over that of the target's bin, right − left.",
            {" / (right - left)": ""},
        ),
        "part_of_the_source": Mistake(
            "this is which part of the source's bin is covered. Asked is which part of the target's bin lies in "
            "it: divide by right − left.",
            {"/ (right - left)": "/ (high - low)"},
        ),
        "touched_in_full": Mistake(
            "a bin that is touched does not count in full: it gets the part of the target's bin that lies in it.",
            {SHARE: "float(common > 0)"},
        ),
        "even_shares": Mistake(
            "every bin that is touched gets the same here. Give each the part that lies in it.",
            {
                APPEND: "shares.append(float(common > 0))",
                "return shares": "return [share / sum(shares) for share in shares]",
            },
        ),
        "middle": Mistake(
            "all goes to the bin in which the middle lies. Give each its part.",
            {SHARE: "float(low < (left + right) / 2 <= high)"},
        ),
        "largest_part": Mistake(
            "all goes to the bin with the largest part. Give each its part.",
            {"return shares": "return [float(share == max(shares)) for share in shares]"},
        ),
        "per_cent": Mistake(
            "this is in per cent. A share lies between 0 and 1.", {"max(0, common)": "100 * max(0, common)"}
        ),
        "leaves_zeros_out": Mistake(
            "bins that share nothing belong into the list, too, with a 0: one number for each bin of the source.",
            CHANGED["leaves_zeros_out"],
        ),
        "not_the_last": Mistake(
            "the last bin of the source is missing: five edges make four bins.", {"len(edges) - 1": "len(edges) - 2"}
        ),
        "not_the_first": Mistake(
            "the first bin of the source is missing: it begins at edges[0].", {"range(": "range(1, "}
        ),
        "smaller_left": Mistake(
            "the common part begins at the larger of the two left ends. This takes the smaller.",
            {"max(left, low)": "min(left, low)"},
        ),
        "larger_right": Mistake(
            "the common part ends at the smaller of the two right ends. This takes the larger.",
            {"min(right, high)": "max(right, high)"},
        ),
        "left_of_the_target": Mistake(
            "the common part begins at the larger of the two left ends, and the target's bin may begin before the "
            "source's.",
            {"max(left, low)": "left"},
        ),
        "left_of_the_source": Mistake(
            "the common part begins at the larger of the two left ends, and the source's bin may begin before the "
            "target's.",
            {"max(left, low)": "low"},
        ),
        "right_of_the_source": Mistake(
            "the common part ends at the smaller of the two right ends, and the target's bin may end before the "
            "source's.",
            {"min(right, high)": "high"},
        ),
        "right_of_the_target": Mistake(
            "the common part ends at the smaller of the two right ends, and the source's bin may end before the "
            "target's.",
            {"min(right, high)": "right"},
        ),
        "return_in_the_loop": Mistake(
            "it ends with the first bin. Does return stand inside a loop?", CHANGED["return_in_the_loop"]
        ),
        "whole_ruler": Mistake(
            "this divides by the length of the whole ruler. Parts of one bin are asked: divide by right − left.",
            {"(right - left)": "(edges[-1] - edges[0])"},
        ),
    },
    hints=(
        "Go through the source's bins. What two intervals have in common begins at the larger of their left ends and "
        "ends at the smaller of their right ends.",
        "low, high = edges[i], edges[i + 1], and then common = min(right, high) - max(left, low). It may be negative.",
        "shares.append(max(0, common) / (right - left)), and after the loop: return shares",
    ),
    gained="A row of these numbers for every bin, for every input: that is all that a change of bins needs.",
    witnesses=WITNESSES,
)
