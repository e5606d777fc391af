"""A task file to begin with: whole, commented, and working."""

from collections.abc import Mapping
from pathlib import Path
from string import Template

from rlrobot_edu.checks import check_name
from rlrobot_edu.files import check_path, write_whole
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.task.robot_cards import ROBOTS, Quantity

# How each file begins, and how it goes on for each robot
TEMPLATES = Path(__file__).parent / "templates"


@suggests_keywords
def new_task(name: str, folder: str | Path = ".", robot: str = "mobile_base") -> Path:
    """Write a task file to begin with; an existing one is never overwritten.

    Parameters
    ----------
    name : str
        Name of the task, in small letters, digits and underscores, as in ``follow_wall``.
    folder : str or Path
        Where the file goes.
    robot : str
        The robot that it is for: ``mobile_base``, ``giraff``, ``arm``, ``mobile_manipulator`` or ``cell_robot``.

    Returns
    -------
    Path
        The file, ``NAME.py``.

    Raises
    ------
    ValueError
        If this cannot be the name of a task, or if there is no such robot.
    OSError
        If there is such a file already (FileExistsError), or it cannot be written.
    """
    if not (isinstance(name, str) and name.isidentifier() and name.islower()):
        raise ValueError(
            "the name of a task is made of small letters, digits and underscores, a letter first, as in follow_wall; "
            f"got {name!r:.200}"
        )
    card = ROBOTS[check_name(robot, ROBOTS, "robot", "a task")]
    path = check_path(folder) / f"{name}.py"
    if path.exists():
        raise FileExistsError(
            f"{path} is there already; choose another name, or move it away"
        )
    head = (TEMPLATES / "head.txt").read_text(encoding="utf-8")
    body = (TEMPLATES / f"{robot}.txt").read_text(encoding="utf-8")
    scenes = list(card.scenes)
    if card.size:
        scenes.append("rooms that you draw (rlrobot_edu.tools.drawing)")
    text = Template(head + body).substitute(
        title=name.replace("_", " ").capitalize(),
        file=path.name,
        robot=robot,
        scene=card.scenes[0],
        scenes=", ".join(scenes),
        sensors=_listed(card.sensors | card.stops),
        commands=_listed(card.commands),
    )
    write_whole(path, text)
    return path


def _listed(quantities: Mapping[str, Quantity]) -> str:
    """One comment line each: name, unit and range."""
    lines = []
    for name, (unit, low, high) in quantities.items():
        lines.append(f"#   {name:<18} {low:g} to {high:g} {unit}")
    return "\n".join(lines)
