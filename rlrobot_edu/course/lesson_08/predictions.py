"""The predictions of lesson 08: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "08_rut": (
        "it falls, and falls",
        "From step 979 on no more reward comes in. Where is the robot?",
    ),
    "08_rare": (
        "a few of the cold ones",
        "Two of ten, for 900 and for 1211 steps.",
    ),
    "08_escape": (
        "21",
        "The queue must be full first. Then the redundancy is 21, and T rises by 5.25.",
    ),
    "08_hot": (
        "probably spin left, perhaps something else",
        "At T = 0.77 it spins left with probability 0.64.",
    ),
    "08_cliff": (
        "more often",
        "It mistakes an agent that is still searching for one that is stuck.",
    ),
}
