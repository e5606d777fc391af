"""The predictions of lesson 08a: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "08a_hot": (
        "probably spin left, perhaps something else",
        "At T = 0.77 it spins left with probability 0.64.",
    ),
    "08a_rare": (
        "a few of the cold ones",
        "Two of ten, for 900 and for 1211 steps.",
    ),
    "08a_cliff": (
        "more often",
        "It mistakes an agent that is still searching for one that is stuck.",
    ),
}
