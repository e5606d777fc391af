"""The predictions of lesson 02a: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "02a alpha": (
        "α = 1",
        "It jumps to each target at once, so it is there soon. The others are still on their way.",
    ),
    "02a gamma": (
        "about half of the reward",
        "A turn earns nothing at once: why should it turn towards the free way?",
    ),
}
