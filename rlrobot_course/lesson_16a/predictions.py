"""The prediction of lesson 16a: for its name, the right answer and the reason."""

OUTCOMES = {
    "16a_heirs": (
        "both",
        "But look at what the Giraff is paid for.",
    ),
}
