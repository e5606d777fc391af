"""What becomes of the predictions of lesson 14: by the name of each the answer that is right, and why."""

OUTCOMES = {
    "14_last": (
        "TOSL+SR",
        "In the paper it was Q+SR. Why, is told in section 6.",
    ),
    "14_often": (
        "in about a tenth of the shuffles",
        "Ten agents of each are too few to tell these two apart for sure.",
    ),
    "14_ahead": (
        "in about a quarter",
        "Ten agents may show almost any difference.",
    ),
}
