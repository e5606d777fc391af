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
    "06 dutch": (
        "0.1: accumulating, 0.5: replacing",
        "With a small α, a new visit wipes out little of the old ones.",
    ),
    "06 robot": (
        "accumulating traces",
        "With α = 0.4 they overshoot at every bump after a drive.",
    ),
}
