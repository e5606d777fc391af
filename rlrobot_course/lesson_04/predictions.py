"""The prediction of lesson 04: for its name, the right answer and the reason."""

OUTCOMES = {
    "04 one step": (
        "far higher, about 0.2",
        "a' was a spin, worth 0, and the next step takes it. Q-learning counts the 2.71, although the robot "
        "does not advance.",
    ),
}
