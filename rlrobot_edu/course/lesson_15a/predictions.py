"""What becomes of the predictions of appendix 15a: by the name of each the answer that is right, and why."""

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
