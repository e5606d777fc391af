"""Colours by role, from the Okabe–Ito set: told apart by colour-blind readers, on light and on dark pages.

Source: Okabe & Ito (2008), *Color Universal Design*, https://jfly.uni-koeln.de/color/.
"""

BLACK, GREY, YELLOW = "#000000", "#7f7f7f", "#f0e442"
ORANGE, SKY, GREEN, BLUE, VERMILION, PURPLE = (
    "#e69f00",
    "#56b4e9",
    "#009e73",
    "#0072b2",
    "#d55e00",
    "#cc79a7",
)

ROLE = dict(
    wall=GREY,
    robot=BLUE,
    wheel=BLACK,
    object=ORANGE,
    goal=GREEN,
    beam=VERMILION,
    path=PURPLE,
)

Dashes = (
    str | tuple[int, tuple[int, ...]]
)  # what matplotlib takes as the style of a line

# a curve differs from its neighbours by its dashes as well as by its colour
_DASHES: tuple[Dashes, ...] = (
    "-",
    "--",
    "-.",
    ":",
    (0, (8, 2)),
    (0, (5, 1, 1, 1, 1, 1)),
    (0, (2, 1)),
)
CURVES = tuple(
    zip((BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, GREY), _DASHES, strict=True)
)
