"""The predictions of lesson 16: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "16_saved": (
        "about 120",
        "Five thoughts a step, and it takes a twentieth of the real steps.",
    ),
    "16_robots": (
        "with 4 states only",
        "In the maze the gain is small, and twenty robots leave it open.",
    ),
}
