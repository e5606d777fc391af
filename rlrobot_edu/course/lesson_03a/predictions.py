"""The predictions of appendix 03a: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "03a units": (
        "rewards × 0.01",
        "All gaps are tiny, so to the softmax all actions are alike: hot.",
    ),
    "03a rules": (
        "it depends on the world",
        "Greedy is fine where no place can hold the robot for ever.",
    ),
}
