"""The errors for names and modules that the package does not have, or cannot load."""

from collections.abc import Callable, Collection
from pathlib import Path
from typing import Any, NoReturn

from rlrobot_edu.checks import did_you_mean

# The module of each name that exists, but not as `rlrobot_edu.NAME`.
ELSEWHERE = {
    "BiasExplorer": "rlrobot_edu.widgets.bias_explorer.explorer",
    "Film": "rlrobot_edu.show.film",
    "History": "rlrobot_edu.learning.history",
    "ParameterSliders": "rlrobot_edu.widgets.sliders",
    "Planner": "rlrobot_edu.learning.algorithm",
    "RobotEnv": "rlrobot_edu.robots.robot_env",
    "RobotLink": "rlrobot_ros",
    "Runs": "rlrobot_edu.experiments.runs",
    "SampleModelEnv": "rlrobot_edu.models.model_env",
    "ServedRobot": "rlrobot_ros",
    "Step": "rlrobot_edu.learning.loop",
    "available_tasks": "rlrobot_edu.task.task_file",
    "best_average_reward": "rlrobot_edu.models.value_iteration",
    "check_task": "rlrobot_edu.tools.check_task",
    "credit": "rlrobot_course.lesson_19.credit",
    "draw_room": "rlrobot_edu.tools.drawing",
    "learn_from": "rlrobot_edu.widgets.driving.teaching",
    "new_task": "rlrobot_edu.tools.new_task",
    "recording_from_bag": "rlrobot_ros",
    "show_scene": "rlrobot_edu.show.in3d.visualizer",
    "teleoperate": "rlrobot_edu.widgets.driving.pad",
    "transfer": "rlrobot_course.lesson_21.transfer",
}
# What the library had once, and what does the same today.
ONCE = {
    "Drawing": "rlrobot_edu.tools.drawing.draw_room draws a room",
    "LiveView": "rl.watch shows a robot while it learns",
    "course": "the lessons are in rlrobot_course, some under other numbers: from rlrobot_course.lesson_03 import check",
    "from_minari": "rl.Recording.from_rows makes a recording of rows",
    "from_parquet": "rl.Recording.from_rows makes a recording of a data frame",
    "merge": "rl.Comparison.load reads a store that several computers have filled",
    "ros": "real robots and their bags are in rlrobot_ros",
    "shard": "rl.compare(…, share=(k, n)) runs the k-th of n shares",
    "to_minari": "Recording.save writes a CSV",
    "to_parquet": "Recording.save writes a CSV, which every data frame reads",
}


def no_such_name(name: str, public: Collection[str]) -> AttributeError:
    """The error that says where a name can be found, or that suggests the nearest one."""
    return AttributeError(_where(name, public), name=name)


def _where(name: str, public: Collection[str]) -> str:
    if name in ELSEWHERE:
        module = ELSEWHERE[name]
        return f"{name} is in {module}: from {module} import {name}"
    if name in ONCE:
        return f"rlrobot_edu has no name {name!r} any more; {ONCE[name]}"
    nearest = did_you_mean(name, [*public, *ELSEWHERE])
    return f"rlrobot_edu has no name {name!r}{nearest} dir(rlrobot_edu) lists all"


class MissingModules:
    """The last of Python's finders. It finds nothing, and says where a module or name has gone.

    So ``from rlrobot_edu import NAME`` is answered as ``rlrobot_edu.NAME`` is.
    """

    def __init__(self, public: Collection[str]) -> None:
        self.public = public

    def find_spec(self, name: str, *_: object) -> None:
        """Raises ModuleNotFoundError for a module of the library that the finders before this one have not found."""
        if not name.startswith(f"{__package__}."):
            return
        folder, last = name.rsplit(".", 1)
        if folder == __package__:
            raise ModuleNotFoundError(_where(last, self.public))
        there = Path(__file__).parent.parent.joinpath(*folder.split("."))
        modules = [path.stem for path in there.glob("[a-z]*")]
        nearest = did_you_mean(last, modules)
        page = "/".join([*folder.split("."), "__init__.py"])
        raise ModuleNotFoundError(
            f"there is no module {name}{nearest} {page} says what is there"
        )


def without_extra(missing: ImportError) -> Callable[..., NoReturn]:
    """A function in place of a name that needs a package which is not installed.

    So `hasattr` and ``import *`` work; a call says what to install.
    """

    def needs_more(*_: Any, **__: Any) -> NoReturn:
        raise missing

    return needs_more
