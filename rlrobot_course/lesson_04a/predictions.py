"""The predictions of appendix 04a: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "04a calm": (
        "Expected SARSA's",
        "Its target has no luck in it, so it bears large steps.",
    ),
    "04a gap": (
        "Q-learning far ahead",
        "But look where it earns it: ten points in every step, for ever?",
    ),
}
