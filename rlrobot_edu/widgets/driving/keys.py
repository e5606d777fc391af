"""The actions of a task as buttons: the text on each, which keys press it, and where it is."""

from __future__ import annotations

import string
from dataclasses import dataclass
from math import dist

from rlrobot_edu.task.robot_cards import WHEELS
from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.wheel_icons import motion, wheel_icon

KEYS = string.digits[1:] + string.ascii_lowercase  # of the buttons, in their order
ARROWS = {
    "ArrowUp": (1, 1),
    "ArrowLeft": (-1, 1),
    "ArrowRight": (1, -1),
    "ArrowDown": (0, 0),
}  # of full speed


@dataclass(frozen=True)
class Button:
    """The button of an action.

    a: number of the action; key: of the keyboard, empty where there are more buttons than keys
    text: on the button; words: what it does; place: its row and column
    """

    a: int
    key: str
    text: str
    words: str
    place: tuple[int, int]


def buttons_of(task: Task) -> list[Button]:
    """A button for each thing the robot can do; of actions with the same command, for the first.

    On wheels a button stands where it takes the robot: ahead is up, left is left. The keys follow the buttons, row by
    row.
    """
    commands = task.commands
    distinct = [a for a, command in enumerate(commands) if command not in commands[:a]]
    icons = (
        [wheel_icon(*commands[a].values()) for a in distinct]
        if has_wheels(task)
        else []
    )
    faces = []
    for i, a in enumerate(distinct):
        text, place = task.actions.label(a), divmod(a, task.actions.shape[-1])
        if icons:
            ahead, turn = motion(*commands[a].values())
            speeds = (
                " {:g}, {:g}".format(*commands[a].values())
                if icons.count(icons[i]) > 1
                else ""
            )
            text, place = icons[i] + speeds, (1 - ahead, 1 - turn)
        words = ", ".join(f"{name} {value:g}" for name, value in commands[a].items())
        faces.append((place, a, text.replace("-", "−"), words.replace("-", "−")))
    return [
        Button(a, KEYS[i : i + 1], text, words, at)
        for i, (at, a, text, words) in enumerate(sorted(faces))
    ]


def keys_of(task: Task) -> dict[str, int]:
    """The action of each key; on wheels, the arrows do what comes nearest to straight on, left, right, stop."""
    buttons = buttons_of(task)
    keys = {button.key: button.a for button in buttons if button.key}
    if has_wheels(task):
        full = max(max(output.values) for output in task.outputs)
        speeds = {
            button.a: tuple(task.command_for(button.a).values()) for button in buttons
        }
        for key, (left, right) in ARROWS.items():
            keys[key] = min(
                speeds, key=lambda a: dist(speeds[a], (full * left, full * right))
            )
    return keys


def has_wheels(task: Task) -> bool:
    """Whether two wheels are all that the task's robot moves."""
    return tuple(task.command_for(0)) == WHEELS
