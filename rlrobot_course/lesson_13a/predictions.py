"""The predictions of lesson 13a: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "13a_wall": (
        "forward, into the wall",
        "In this model any state at random is better than this corner.",
    ),
    "13a_promise": (
        "nearly 10",
        "They sit in a loop that one lucky step has made.",
    ),
    "13a_longer": (
        "no",
        "More rows break a few loops, and each new corner brings new ones.",
    ),
}
