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
    "12_heats": (
        "nothing",
        "It looks for loops of low reward, and this one pays 2 a step.",
    ),
    "12_loops": (
        "3 and 2",
        "Two paid steps in for one step out; and where that costs 5, out by steps of less than 2 cm.",
    ),
}
