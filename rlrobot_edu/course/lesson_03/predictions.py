"""The predictions of lesson 03: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "03 greedy": (
        "nearly all",
        "Nine of the ten. The mean hides it, and its band is wide. Look at each alone:",
    ),
    "03 ties": (
        "1",
        "It runs into the left edge 20,000 times, and no error message tells why.",
    ),
    "03 temperature": (
        "none",
        "The order never changes; but P(1) first rises with T, and then falls.",
    ),
    "03 probability": (
        "0.58",
        "e / (e + 1 + 1). The more often it pays, the larger its Q, and the surer the choice.",
    ),
    "03 library": (
        "all 1000",
        "The same u, the same action, the same world: your code and the library's are one algorithm.",
    ),
}
