"""What becomes of the predictions of lesson 00: by the name of each the answer that is right, and why."""

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
