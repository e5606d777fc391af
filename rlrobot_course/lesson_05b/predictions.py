"""The predictions of lesson 05b: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "05b sweep": (
        "0.8 to 0.9",
        "λ = 0 believes too much, λ = 1 hangs on luck; between them lies a valley.",
    ),
    "05b harder": (
        "0.9",
        "Several steps lead away from a wall that holds the robot, and a trace credits all of them.",
    ),
}
