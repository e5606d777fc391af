"""The predictions of lesson 13: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "13_start": (
        "nearly as good as ever after",
        "Ten minutes of rows, used again and again, taught it all.",
    ),
    "13_wall": (
        "forward, into the wall",
        "In this model any state at random is better than this corner.",
    ),
    "13_promise": (
        "nearly 10",
        "They sit in a loop that one lucky step has made.",
    ),
    "13_longer": (
        "no",
        "More rows break a few loops, and each new corner brings new ones.",
    ),
}
