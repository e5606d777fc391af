"""The predictions of lesson 00: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "00 bumps": (
        "about ten",
        "Most steps only turn it, so it seldom gets to a wall; but there it fumbles.",
    ),
    "00 best action": (
        "both wheels −1",
        "In this task that command means “forward at double speed”.",
    ),
    "00 rival": (
        "worse",
        "It learns more slowly at first, and at the end of the hour its band lies just below the other.",
    ),
}
