"""The actions of a task as buttons: their texts, their keys and their places."""

from __future__ import annotations

import string
from dataclasses import dataclass
from math import dist

from rlrobot_edu.task.robot_cards import WHEELS
from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.wheel_icons import motion, wheel_icon

KEYS = string.digits[1:] + string.ascii_lowercase  # of the buttons, in their order
# The speeds of the wheels for each arrow, in parts of full speed
ARROWS = {
    "ArrowUp": (1, 1),
    "ArrowLeft": (-1, 1),
    "ArrowRight": (1, -1),
    "ArrowDown": (0, 0),
}


@dataclass(frozen=True)
class Button:
    """The button of an action.

    a: number of the action; key: of the keyboard, empty if there are more buttons than keys
    text: on the button; words: the robot's command; place: its row and column
    """

    a: int
    key: str
    text: str
    words: str
    place: tuple[int, int]


def buttons_of(task: Task) -> list[Button]:
    """A button for each command of the robot; of actions with the same command, for the first.

    On wheels, the place of a button is the direction of the motion: ahead is up, left is left. The keys follow the
    buttons, row by row.
    """
    commands = task.commands
    distinct = [a for a, command in enumerate(commands) if command not in commands[:a]]
    icons = []
    if has_wheels(task):
        icons = [wheel_icon(*commands[a].values()) for a in distinct]
    faces = []
    for i, a in enumerate(distinct):
        if icons:
            left, right = commands[a].values()
            ahead, turn = motion(left, right)
            place = (1 - ahead, 1 - turn)
            text = icons[i]
            if icons.count(text) > 1:
                text = f"{text} {left:g}, {right:g}"
        else:
            place = divmod(a, task.actions.shape[-1])
            text = task.actions.label(a)
        words = ", ".join(f"{name} {value:g}" for name, value in commands[a].items())
        faces.append((place, a, text.replace("-", "−"), words.replace("-", "−")))
    buttons = []
    for i, (place, a, text, words) in enumerate(sorted(faces)):
        key = KEYS[i] if i < len(KEYS) else ""
        buttons.append(Button(a, key, text, words, place))
    return buttons


def keys_of(task: Task) -> dict[str, int]:
    """The action of each key; on wheels, the arrows do what is nearest to straight on, left, right and stop."""
    buttons = buttons_of(task)
    keys = {button.key: button.a for button in buttons if button.key}
    if not has_wheels(task):
        return keys
    full = max(max(output.values) for output in task.outputs)
    for key, (left, right) in ARROWS.items():
        wanted = (full * left, full * right)
        distances = {}
        for button in buttons:
            speeds = tuple(task.command_for(button.a).values())
            distances[button.a] = dist(speeds, wanted)
        keys[key] = min(distances, key=distances.__getitem__)
    return keys


def has_wheels(task: Task) -> bool:
    """Whether two wheels are all that the task's robot moves."""
    return tuple(task.command_for(0)) == WHEELS
