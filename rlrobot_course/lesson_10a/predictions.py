"""The prediction of lesson 10a: for its name, the right answer and the reason."""

OUTCOMES = {
    "10a late": (
        "more",
        "It is late at every wall, and yet it earns more.",
    ),
}
