"""The predictions of lesson 02a: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "02a alpha": (
        "α = 1",
        "The table believes its last step and forgets all others.",
    ),
    "02a gamma": (
        "about half of the reward",
        "A turn earns nothing at once: why should it turn towards the free way?",
    ),
}
