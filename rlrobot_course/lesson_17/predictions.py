"""The predictions of lesson 17: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "17 carried": (
        "only the Giraff",
        "Half of the other one's commands were held back.",
    ),
    "17 rehearsal": (
        "the one with all, in wrong sizes",
        "That walls hold mattered most, and to know it at all was enough.",
    ),
}
