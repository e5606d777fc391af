"""The predictions of appendix 05a: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "05a dropped": (
        "no difference to be seen",
        "Each curve lies well inside the other's band. Nobody misses the faint traces.",
    ),
}
