"""One list of colours for figures, films, pages and views in 3D, on light and on dark grounds.

Each colour stands for one thing. None stands alone: a second sign, such as a name, a mark or dashes, says the same.
The hues are Okabe and Ito's, which colour-blind readers can tell apart, made darker until letters in them can be read
on white. Source: Okabe & Ito (2008), *Color Universal Design*, https://jfly.uni-koeln.de/color/.
"""

# What a page, a figure or a room is made of
LIGHT = {
    "paper": "#ffffff",
    "back": "#faf8f4",  # behind the cards of a page
    "card": "#fffdf9",
    "ink": "#1d2327",
    "faint": "#565d63",  # letters that explain
    "line": "#dcd7cd",
    "floor": "#f0ece4",
    "wall": "#6d6a66",
    "blue": "#0067a5",  # the robot, what one may press, and what is compared with the rest
    "on-blue": "#ffffff",
    "green": "#007a58",  # what was paid: gains, goals
    "red": "#c24e00",  # what was lost: bumps
    "grey": "#8d877d",  # what neither gains nor loses, and what others are compared with
    "orange": "#e69f00",  # a laser; too light for letters
    "purple": "#9c4a7c",
    "sky": "#4fa3d8",  # too light for letters
    "input-1": "#a97a00",
    "input-2": "#13879c",
    "input-3": "#b8558d",
    "input-4": "#7453c0",
    "input-5": "#737d0c",
    "input-6": "#8a5a3c",
    "on-input": "#ffffff",
    "focus": "#b26b00",  # round what the keyboard has chosen
}
DARK = {
    "paper": "#1d1f22",
    "back": "#131416",
    "card": "#1d1f22",
    "ink": "#eceae6",
    "faint": "#adb3b8",
    "line": "#3a3e43",
    "floor": "#22252a",
    "wall": "#8b9097",
    "blue": "#56b4e9",
    "on-blue": "#0e1418",
    "green": "#3ddab4",
    "red": "#ff9a4d",
    "grey": "#8b9097",
    "orange": "#f0b429",
    "purple": "#e39ac6",
    "sky": "#3f86b3",
    "input-1": "#f0b429",
    "input-2": "#4cc5dc",
    "input-3": "#e08fbd",
    "input-4": "#ab93f0",
    "input-5": "#b8c23c",
    "input-6": "#cf9f7c",
    "on-input": "#15181a",
    "focus": "#e69f00",
}

BLACK = LIGHT["ink"]
WHITE = LIGHT["paper"]
GREY = LIGHT["grey"]
ORANGE = LIGHT["orange"]
SKY = LIGHT["sky"]
GREEN = LIGHT["green"]
BLUE = LIGHT["blue"]
RED = LIGHT["red"]
PURPLE = LIGHT["purple"]

ROLE = {
    "wall": LIGHT["wall"],
    "robot": BLUE,
    "wheel": BLACK,
    "object": ORANGE,
    "goal": GREEN,
    "beam": ORANGE,
    "path": SKY,
}

# Shades: from what is worth nothing to what is worth most, and from little to much of anything else
WORTH = ("#e9e4da", "#7fc3ab", GREEN, "#003b2b")
BLUES = (LIGHT["paper"], SKY, BLUE)

# What things are made of that are drawn in no colour of their own
METAL = "#a9b0b8"
WOOD = "#c08b55"
FIELD = "#e6dfc8"  # paint on a table
BACKDROP = LIGHT["line"]  # behind a room that is filmed
SCREEN = "#dfe3e8"
GLASS = "#8fc7ea"
SHINE = "#2a2a2a"  # how much light comes back from what shines

# The style of a line, as matplotlib takes it
Dashes = str | tuple[int, tuple[int, ...]]

# Neighbouring curves differ in their dashes as well as in their colours.
CURVES: tuple[tuple[str, Dashes], ...] = (
    (BLUE, "-"),
    (RED, "--"),
    (GREEN, "-."),
    (PURPLE, ":"),
    (ORANGE, (0, (8, 2))),
    (SKY, (0, (5, 1, 1, 1, 1, 1))),
    (GREY, (0, (2, 1))),
)
