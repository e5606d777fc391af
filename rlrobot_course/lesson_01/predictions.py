"""The predictions of lesson 01: for the name of each, the right answer and the reason."""

OUTCOMES = {
    "01 number": (
        "15",
        "((1 · 2 + 0) · 3 + 1) · 2 + 1 = 15.",
    ),
    "01 right turn": (
        "action 2",
        "Left wheel forward, right wheel backward.",
    ),
    "01 careful": (
        "stand or turn on the spot",
        "Turning on the spot touches nothing and earns the full reward, step after step. Nothing pays for driving.",
    ),
    "01 stern": (
        "stand or turn on the spot",
        "Two of the three. Whoever once lost 100 at a wall, and earns 10 for driving, dares nothing there any more.",
    ),
}
