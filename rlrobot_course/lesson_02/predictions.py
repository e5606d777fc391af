"""The predictions of lesson 02: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "02 turn": (
        "it rises",
        "From the next state the robot once advanced for 10: its best action is worth 1 already.",
    ),
    "02 off-policy": (
        "many times better",
        "The table is about the best actions, whatever the robot did while it learned.",
    ),
}
