"""The predictions of appendix 07a: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "07a forgotten": (
        "for ten visits or more",
        "It takes the advice, so nothing tells it that the advice was wrong.",
    ),
    "07a ahead": (
        "more than twice as often",
        "State 3 counts a quarter in their bias, and there are few others to ask.",
    ),
}
