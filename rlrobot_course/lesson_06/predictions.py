"""The predictions of lesson 06: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "06 redone": (
        "55",
        "1 + 2 + … + 10: in each step all updates so far are done again.",
    ),
    "06 bump": (
        "accumulating traces",
        "They climb with the ideal, and then fall more than a hundred below it.",
    ),
    "06 robot": (
        "they cannot be told apart",
        "The bands of the two overlap all the way.",
    ),
}
