"""The predictions of lesson 03a: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "03a temperature": (
        "none",
        "The order never changes; but P(1) first rises with T, and then falls.",
    ),
    "03a probability": (
        "0.58",
        "e / (e + 1 + 1). The more often it pays, the larger its Q, and the surer the choice.",
    ),
    "03a units": (
        "rewards × 0.01",
        "All gaps are tiny, so to the softmax all actions are alike: hot.",
    ),
    "03a ties": (
        "1",
        "It runs into the left edge 20,000 times, and no error message tells why.",
    ),
    "03a rules": (
        "it depends on the world",
        "Greedy is fine where no place can hold the robot for ever.",
    ),
}
