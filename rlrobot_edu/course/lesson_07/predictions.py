"""The predictions of lesson 07: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "07 similar": (
        "5",
        "One with the other X, one with the other Y, two with another θ, one with the other d.",
    ),
    "07 ageing": (
        "about a third",
        "It does not fade. You will find the reason in the next exercise.",
    ),
    "07 echo": (
        "softmax at T = 0.69",
        "At first it goes with QBIASSR, later it is a little ahead.",
    ),
    "07 maze": (
        "yes, clearly",
        "Here similar states have something to say, and the cold alone brings nothing.",
    ),
    "07 small": (
        "without",
        "The state “both far” is so good that its neighbours are advised to drive on, into the wall.",
    ),
}
