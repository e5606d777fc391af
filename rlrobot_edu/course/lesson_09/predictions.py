"""What becomes of the predictions of lesson 09: by the name of each the answer that is right, and why."""

OUTCOMES = {
    "09_far": (
        "a quarter more, or better",
        "A third more: what one state has learned helps its likes.",
    ),
    "09_never": (
        "one is clearly the most probable",
        "Both wheels 1, 61 %: it paid in similar states.",
    ),
}
