"""The predictions of lesson 04b: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "04b way": (
        "Q-learning",
        "SARSA's agents climb one or two rows before they turn right.",
    ),
    "04b pay": (
        "SARSA's",
        "The agent with the better promise earns less: it keeps falling off the edge.",
    ),
    "04b shyer": (
        "it goes away",
        "Without exploring, “go on as I do” and “act best from now on” mean the same.",
    ),
    "04b fading": (
        "one farther off",
        "Not one of the agents is back at the edge, though without exploring it would be the best way.",
    ),
    "04b robot": (
        "they cannot be told apart",
        "With ten robots each, the bands overlap from the beginning to the end.",
    ),
}
