"""The prediction of lesson 16b: for its name, the right answer and the reason."""

OUTCOMES = {
    "16b_blind": (
        "as much as VBIASSR",
        "It has found a circle that pays in every step, and needs to see nothing for it.",
    ),
}
