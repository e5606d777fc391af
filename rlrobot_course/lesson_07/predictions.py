"""The predictions of lesson 07: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "07 similar": (
        "5",
        "One with the other X, one with the other Y, two with another θ, one with the other d.",
    ),
    "07 maze": (
        "yes, clearly",
        "Here similar states have something to say, and the cold alone brings nothing.",
    ),
}
