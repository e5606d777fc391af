"""The predictions of lesson 14: for the name of each, the right answer and the reason."""

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
