"""The predictions of lesson 08: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "08_rut": (
        "it falls, and falls",
        "From step 979 on no more reward comes in. Where is the robot?",
    ),
    "08_escape": (
        "21",
        "The queue must be full first. Then the redundancy is 21, and T rises by 5.25.",
    ),
}
