"""The predictions of lesson 04: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "04 one step": (
        "far higher, about 0.2",
        "a' was a spin, worth 0, and the next step takes it. Q-learning counts the 2.71, although the robot "
        "does not advance.",
    ),
    "04 way": (
        "Q-learning",
        "SARSA's agents climb one or two rows before they turn right.",
    ),
    "04 pay": (
        "SARSA's",
        "The agent with the better promise earns less: it keeps falling off the edge.",
    ),
    "04 shyer": (
        "it goes away",
        "Without exploring, “go on as I do” and “act best from now on” mean the same.",
    ),
    "04 robot": (
        "they cannot be told apart",
        "With ten robots each, the bands overlap from the beginning to the end.",
    ),
}
