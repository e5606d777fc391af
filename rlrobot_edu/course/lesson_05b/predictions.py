"""The prediction of lesson 05b: for its name, the right answer and the reason."""

OUTCOMES = {
    "05b sweep": (
        "0.8 to 0.9",
        "λ = 0 believes too much, λ = 1 hangs on luck; between them lies a valley.",
    ),
}
