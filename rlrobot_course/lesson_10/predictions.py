"""The predictions of lesson 10: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "10 side": (
        "some left, some right",
        "The square is the same from both sides: luck decides, and then it stays so.",
    ),
    "10 wall": (
        "it drives on",
        "See the first picture: state 15. It pays nearly 10 a step.",
    ),
    "10 elsewhere": (
        "clearly more than beginners",
        "What it knows is about walls, not about this maze.",
    ),
}
