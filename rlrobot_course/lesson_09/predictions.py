"""The predictions of lesson 09: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "09_far": (
        "a quarter more, or better",
        "A third more: what one state has learned helps its likes.",
    ),
    "09_never": (
        "about 60 %",
        "Both wheels 1, 61 %: it paid in similar states.",
    ),
}
