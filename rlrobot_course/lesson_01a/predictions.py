"""The predictions of appendix 01a: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "01a always left": (
        "truncated",
        "It never gets anywhere, so the world never ends it. After 100 steps time is up.",
    ),
    "01a worst policy": (
        "always forward",
        "It drives seven steps, and then pushes against the wall for the rest of them.",
    ),
    "01a patience": (
        "only 0.99",
        "γ¹⁰ is 0.35 for γ = 0.9, and 0.90 for γ = 0.99.",
    ),
    "01a sweeps": (
        "2",
        "Those beside the goal. After the second sweep there are four, after the third seven.",
    ),
    "01a advance": (
        "by about 1",
        "Who turns first can advance one step later, and has the way to the other side before it.",
    ),
}
