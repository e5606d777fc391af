"""What becomes of the predictions of appendix 05a: by the name of each the answer that is right, and why."""

OUTCOMES = {
    "05a dropped": (
        "no difference to be seen",
        "Each curve lies well inside the other's band. Nobody misses the faint traces.",
    ),
}
