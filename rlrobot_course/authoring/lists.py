"""The lessons are the notebooks in `notebooks/`; what lists say of them stands in the metadata of each."""

import json
import re
from pathlib import Path
from typing import Any, NamedTuple

import rlrobot_course
from rlrobot_edu.files import write_whole

# How long a lesson takes: so many words and so many lines of code that it shows are read in a minute, and so many
# minutes go by with an exercise and with a prediction. It gives 16 hours for the lessons of the fourth edition, which
# their readers had estimated, too. No learner has been timed.
WORDS = 100
LINES = 7
EXERCISE = 6
PREDICTION = 1

TABLE = "| lesson | what you write | minutes |\n|---|---|---|\n"  # how that of docs/lessons.md begins


class Lesson(NamedTuple):
    """What a list says of a lesson. needs: the numbers of lessons; writes: what the learner writes, in some words."""

    path: Path
    title: str
    minutes: int
    needs: list[str]
    writes: str

    @property
    def is_optional(self) -> bool:
        """Whether the lesson lies beside the road, in `notebooks/more/`."""
        return self.path.parent.name == "more"


def checkout() -> Path:
    """The folder of the project. Raises ValueError where the package is installed without it."""
    root = Path(rlrobot_course.__file__).parents[1]
    if not (root / "tests/course").is_dir():
        raise ValueError(
            f"lessons are written in a clone of the project, with notebooks/ and tests/, not in {root}"
        )
    return root


def lessons(root: Path) -> dict[str, Path]:
    """The notebook of each lesson, by its number as in 04, in the order of the course; those in `more/` come last."""
    paths = [
        *sorted(root.glob("notebooks/*.ipynb")),
        *sorted(root.glob("notebooks/more/*.ipynb")),
    ]
    return {path.name.partition("_")[0]: path for path in paths}


def facts(root: Path) -> dict[str, Lesson]:
    """What the notebooks say of themselves, by the numbers of the lessons."""
    found = {}
    for number, path in lessons(root).items():
        notebook = json.loads(path.read_text(encoding="utf-8"))
        title = (
            "".join(notebook["cells"][0]["source"])
            .partition("\n")[0]
            .removeprefix(f"# {number} ")
        )
        about = notebook["metadata"]["rlrobot_edu"]
        found[number] = Lesson(
            path, title, about["minutes"], about["needs"], about["writes"]
        )
    return found


def estimated(notebook: dict[str, Any]) -> int:
    """How long a lesson takes, by the rule above [minutes, in fives].

    notebook: as JSON has it
    """
    words = lines = exercises = predictions = 0
    for cell in notebook["cells"]:
        text = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            words += len(text.split())
            continue
        exercises += len(set(re.findall(r"^check\.(\w+)\(", text, re.MULTILINE)))
        predictions += text.count("Prediction(")
        is_folded = cell["metadata"].get("jupyter", {}).get("source_hidden", False)
        if not is_folded:
            lines += sum(bool(line.strip()) for line in text.splitlines())
    minutes = words / WORDS + lines / LINES
    minutes += EXERCISE * exercises + PREDICTION * predictions
    return 5 * round(minutes / 5)


def table(root: Path) -> str:
    """The rows of the table of the course in docs/lessons.md."""
    rows = [
        f"| [{number} {one.title}](../{one.path.relative_to(root).as_posix()}){', optional' * one.is_optional}"
        f" | {one.writes} | {one.minutes} |\n"
        for number, one in facts(root).items()
    ]
    return "".join(rows)


def write_table(root: Path) -> None:
    """Write the table of the course into docs/lessons.md anew."""
    page = root / "docs/lessons.md"
    before, head, after = page.read_text(encoding="utf-8").partition(TABLE)
    write_whole(page, before + head + table(root) + re.sub(r"^(\|.*\n)*", "", after))


def notebook_of(root: Path, number: str) -> Path:
    """The notebook of one lesson. Raises ValueError if there is none; the message lists the lessons."""
    known = lessons(root)
    if number not in known:
        raise ValueError(
            f"there is no lesson {number!r} in notebooks/; the lessons are {', '.join(known)}"
        )
    return known[number]
