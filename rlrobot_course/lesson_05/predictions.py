"""The predictions of lesson 05: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "05 known": (
        "10",
        "The reward moves one cell an episode.",
    ),
    "05 same": (
        "5",
        "The whole way hears of the reward in the first episode; four more put right what it heard.",
    ),
    "05 goal": (
        "both in the same step",
        "As long as every reward is 0 there is nothing to learn. Traces do not find rewards.",
    ),
}
