"""The predictions of lesson 12a: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "12a_heats": (
        "nothing",
        "It looks for loops of low reward, and this one pays 2 a step.",
    ),
    "12a_loops": (
        "3 and 2",
        "Two paid steps in for one step out; and where that costs 5, out by steps of less than 2 cm.",
    ),
}
