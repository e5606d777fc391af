"""What becomes of the predictions of appendix 06a: by the name of each the answer that is right, and why."""

OUTCOMES = {
    "06a trouble": (
        "0.2 or 0.3",
        "The limit that you found is 0.19.",
    ),
}
