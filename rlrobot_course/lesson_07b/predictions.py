"""The predictions of lesson 07b: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "07b ageing": (
        "about a third",
        "It does not fade. You will find the reason in the next exercise.",
    ),
    "07b echo": (
        "softmax at T = 0.69",
        "At first it goes with QBIASSR, later it is a little ahead.",
    ),
    "07b small": (
        "without",
        "The state “both far” is so good that its neighbours are advised to drive on, into the wall.",
    ),
}
