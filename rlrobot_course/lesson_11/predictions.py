"""The predictions of lesson 11: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "11 how long": (
        "about 60",
        "It falls fast, then it jumps about, and then it settles.",
    ),
    "11 next to it": (
        "away from it",
        "The goal pays 10, once. To and fro is worth more.",
    ),
    "11 reverse": (
        "never, or hardly ever",
        "It has found something that pays without end.",
    ),
}
