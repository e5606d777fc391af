"""The errors for names that the package does not have, or cannot load."""

from collections.abc import Callable, Collection
from typing import Any, NoReturn

from rlrobot_edu.checks import did_you_mean

# The module of each name that exists, but not as `rlrobot_edu.NAME`.
ELSEWHERE = {
    "BiasExplorer": "rlrobot_edu.widgets.bias_explorer.explorer",
    "Film": "rlrobot_edu.show.film",
    "History": "rlrobot_edu.learning.history",
    "ParameterSliders": "rlrobot_edu.widgets.sliders",
    "Planner": "rlrobot_edu.learning.algorithm",
    "RobotLink": "rlrobot_ros",
    "ServedRobot": "rlrobot_ros",
    "available_tasks": "rlrobot_edu.task.task_file",
    "check_task": "rlrobot_edu.tools.check_task",
    "credit": "rlrobot_course.lesson_19.credit",
    "learn_from": "rlrobot_edu.widgets.driving.teaching",
    "new_task": "rlrobot_edu.tools.new_task",
    "recording_from_bag": "rlrobot_ros",
    "show_scene": "rlrobot_edu.show.in3d.visualizer",
    "teleoperate": "rlrobot_edu.widgets.driving.pad",
    "transfer": "rlrobot_course.lesson_21.transfer",
}


def no_such_name(name: str, public: Collection[str]) -> AttributeError:
    """The error that says where a name can be found, or that suggests the nearest one."""
    if name in ELSEWHERE:
        module = ELSEWHERE[name]
        return AttributeError(
            f"{name} is in {module}: from {module} import {name}", name=name
        )
    advice = did_you_mean(name, [*public, *ELSEWHERE]).strip()
    return AttributeError(
        f"rlrobot_edu has no name {name!r}; {advice or 'dir(rlrobot_edu) lists them'}",
        name=name,
    )


def without_extra(missing: ImportError) -> Callable[..., NoReturn]:
    """A function in place of a name that needs a package which is not installed.

    So `hasattr` and ``import *`` work; a call says what to install.
    """

    def needs_more(*_: Any, **__: Any) -> NoReturn:
        raise missing

    return needs_more
