"""The predictions of appendix 06a: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "06a trouble": (
        "0.2 or 0.3",
        "The limit that you found is 0.19.",
    ),
}
