"""The predictions of lesson 05: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "05 known": (
        "10",
        "The reward moves one cell an episode.",
    ),
    "05 first": (
        "10",
        "The whole way has heard of the reward after one episode.",
    ),
    "05 goal": (
        "both in the same step",
        "As long as every reward is 0 there is nothing to learn. Traces do not find rewards.",
    ),
    "05 sweep": (
        "0.8 to 0.9",
        "λ = 0 believes too much, λ = 1 hangs on luck; between them lies a valley.",
    ),
}
