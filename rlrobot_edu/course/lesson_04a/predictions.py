"""What becomes of the predictions of appendix 04a: by the name of each the answer that is right, and why."""

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
