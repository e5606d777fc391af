"""The predictions of lesson 15: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "15_park": (
        "to drive to and fro",
        "A step away costs 0.4, the step back pays 10. Being there pays nothing.",
    ),
}
