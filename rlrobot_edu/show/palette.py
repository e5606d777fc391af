"""Colours by role, from the Okabe–Ito set: colour-blind readers can tell them apart, on light and on dark pages.

Source: Okabe & Ito (2008), *Color Universal Design*, https://jfly.uni-koeln.de/color/.
"""

BLACK = "#000000"
GREY = "#7f7f7f"
YELLOW = "#f0e442"
ORANGE = "#e69f00"
SKY = "#56b4e9"
GREEN = "#009e73"
BLUE = "#0072b2"
VERMILION = "#d55e00"
PURPLE = "#cc79a7"

ROLE = {
    "wall": GREY,
    "robot": BLUE,
    "wheel": BLACK,
    "object": ORANGE,
    "goal": GREEN,
    "beam": VERMILION,
    "path": PURPLE,
}

# The style of a line, as matplotlib takes it
Dashes = str | tuple[int, tuple[int, ...]]

# Neighbouring curves differ in their dashes as well as in their colours.
CURVES: tuple[tuple[str, Dashes], ...] = (
    (BLUE, "-"),
    (VERMILION, "--"),
    (GREEN, "-."),
    (PURPLE, ":"),
    (ORANGE, (0, (8, 2))),
    (SKY, (0, (5, 1, 1, 1, 1, 1))),
    (GREY, (0, (2, 1))),
)
