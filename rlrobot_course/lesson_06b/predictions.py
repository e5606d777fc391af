"""The predictions of lesson 06b: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "06b dutch": (
        "0.1: accumulating, 0.5: replacing",
        "With a small α, a new visit wipes out little of the old ones.",
    ),
    "06b small": (
        "replacing traces",
        "Credit for the latest visit alone is too little, and nothing overshoots any more.",
    ),
}
