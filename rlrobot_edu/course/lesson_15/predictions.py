"""The predictions of lesson 15: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "15_compass": (
        "those without",
        "The room looks the same from all four sides, so heading tells nothing useful.",
    ),
    "15_lazy": (
        "10 in all steps",
        "Seen from the middle, the spot is always 0.45 m away.",
    ),
}
