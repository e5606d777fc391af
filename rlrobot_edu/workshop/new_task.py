"""A task file to begin with: whole, commented, and working."""

from collections.abc import Mapping
from pathlib import Path
from string import Template

from rlrobot_edu.files import write_whole
from rlrobot_edu.task.robot_cards import ROBOTS, Quantity

ROBOT = "mobile_base"  # of the template


def new_task(name: str, folder: str | Path = ".") -> Path:
    """Write a task file to begin with; an existing one is never overwritten.

    Parameters
    ----------
    name : str
        Name of the task, in small letters, digits and underscores, as in ``follow_wall``.
    folder : str or Path
        Where the file goes.

    Returns
    -------
    Path
        The file, ``NAME.py``.

    Raises
    ------
    ValueError
        If this cannot be the name of a task.
    FileExistsError
        If there is such a file already.
    """
    if not (isinstance(name, str) and name.isidentifier() and name.islower()):
        expected = "small letters, digits and underscores, a letter first, as in follow_wall"
        raise ValueError(f"the name of a task is made of {expected}; got {name!r:.200}")
    path = Path(folder, f"{name}.py")
    if path.exists():
        raise FileExistsError(f"{path} is there already; choose another name, or move it away")
    card = ROBOTS[ROBOT]
    template = Template(Path(__file__).with_name("template.txt").read_text(encoding="utf-8"))
    text = template.substitute(
        title=name.replace("_", " ").capitalize(), file=path.name, robot=ROBOT, scene=card.scenes[0],
        scenes=", ".join(card.scenes), sensors=_listed(card.sensors), commands=_listed(card.commands),
    )  # fmt: skip
    write_whole(path, text)
    return path


def _listed(quantities: Mapping[str, Quantity]) -> str:
    """One comment line each: name, unit and range."""
    return "\n".join(f"#   {name:<18} {q.low:g} to {q.high:g} {q.unit}" for name, q in quantities.items())
