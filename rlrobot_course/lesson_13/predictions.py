"""The prediction of lesson 13: for its name, the right answer and the reason."""

OUTCOMES = {
    "13_start": (
        "nearly as good as ever after",
        "Ten minutes of rows, used again and again, taught it all.",
    ),
}
