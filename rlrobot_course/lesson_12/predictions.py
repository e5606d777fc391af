"""The predictions of lesson 12: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "12_states": (
        "a thirty-second, at most 32",
        "The object's bins never change: 4 · 8 states are left.",
    ),
    "12_eight": (
        "four or five",
        "Four. The others do not scatter at random below 8. Look at their numbers.",
    ),
    "12_lazy": (
        "nearly 10",
        "9.83. It swings against the object, is stopped there and stays in contact. Yours passes through.",
    ),
}
