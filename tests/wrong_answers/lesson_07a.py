"""Typical wrong answers of appendix 07a, and a word of the hint each must get."""

WRONG = {
    "best_adviser": [
        ("line", "on the other side"),
        ("Ahead", "a crash"),
        ("trailer", "change places"),
        ("all", "not equally good"),
        ("none", "hardly matters"),
        (4, "in quotation marks"),
        (["floor"], "out of its brackets"),
        ("all of them", "one word"),
        ("trialer", "spelled"),
        ("colour", "as in the table"),
        ("d", "robot of lesson 07"),
    ],
}
