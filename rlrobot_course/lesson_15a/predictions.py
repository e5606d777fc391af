"""The predictions of appendix 15a: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "15a ahead": (
        "still behind",
        "The last 200 steps say so: the average over all steps remembers the start for long.",
    ),
    "15a clumsy": (
        "better",
        "It showed what a bump costs, and its few good steps, too.",
    ),
    "15a copy": (
        "of those that copy",
        "They have nothing but the teacher's hands; its mistakes are theirs.",
    ),
}
