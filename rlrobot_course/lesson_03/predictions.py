"""The predictions of lesson 03: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "03 greedy": (
        "nearly all",
        "Nine of the ten. The mean hides it, and its band is wide. Look at each alone:",
    ),
}
