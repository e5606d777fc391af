"""The actions of a task as buttons: their texts, their keys and their places."""

from __future__ import annotations

import string
from dataclasses import dataclass, replace
from math import dist

from rlrobot_edu.task.robot_cards import WHEELS
from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.motions import motion_of, signs

BUTTON_KEYS = string.digits[1:] + string.ascii_lowercase  # row by row
# The speeds of the wheels for each arrow, in parts of full speed
ARROWS = {
    "ArrowUp": (1, 1),
    "ArrowLeft": (-1, 1),
    "ArrowRight": (1, -1),
    "ArrowDown": (0, 0),  # stop: few tasks have a way back
}


@dataclass(frozen=True)
class Button:
    """The button of an action.

    a: number of the action; key: of the keyboard, empty if there are more buttons than keys
    text: on the button; name: of what the robot does; words: its command; place: its row and column
    """

    a: int
    key: str
    text: str
    name: str
    words: str
    place: tuple[int, int]


def buttons_of(task: Task) -> list[Button]:
    """A button for each command of the robot; of actions with the same command, for the first.

    On wheels, the place of a button is the direction of the motion: ahead is up, left is left. The keys follow the
    buttons, row by row.
    """
    commands = task.commands
    distinct = [a for a, command in enumerate(commands) if command not in commands[:a]]
    if has_wheels(task):
        places = [_place_of_motion(*commands[a].values()) for a in distinct]
        texts = _icons([tuple(commands[a].values()) for a in distinct])
        names = [motion_of(*commands[a].values()).name for a in distinct]
    else:
        # a column for each value of the last output
        places = [divmod(a, task.actions.shape[-1]) for a in distinct]
        texts = [task.actions.label(a) for a in distinct]
        names = texts
    buttons = []
    for a, place, text, name in zip(distinct, places, texts, names, strict=True):
        words = ", ".join(f"{key} {value:g}" for key, value in commands[a].items())
        signs_and_words = [each.replace("-", "−") for each in (text, name, words)]
        buttons.append(Button(a, "", *signs_and_words, place))
    buttons.sort(key=lambda button: (button.place, button.a))  # row by row
    keys = BUTTON_KEYS.ljust(len(buttons))
    return [replace(buttons[i], key=keys[i].strip()) for i in range(len(buttons))]


def _place_of_motion(left: float, right: float) -> tuple[int, int]:
    """Row and column among 3 × 3: ahead is the top row, a turn to the left the left column."""
    ahead, turn = signs(left, right)
    return (1 - ahead, 1 - turn)


def _icons(speeds: list[tuple[float, ...]]) -> list[str]:
    """An arrow for each pair of wheel speeds, with the speeds where several have the same arrow."""
    icons = [motion_of(left, right).icon for left, right in speeds]
    texts = []
    for icon, (left, right) in zip(icons, speeds, strict=True):
        is_unique = icons.count(icon) == 1
        texts.append(icon if is_unique else f"{icon} {left:g}, {right:g}")
    return texts


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
