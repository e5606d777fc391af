"""A new lesson that passes its own checks at once: it is written from `template/`, and its author then changes it."""

import re
import subprocess
import sys
import unicodedata
from pathlib import Path

from rlrobot_course.authoring import lists
from rlrobot_edu.files import write_together

TEMPLATE = Path(__file__).parent / "template"
QUESTIONS = "rlrobot_course/questions/questions.toml"
LEFT = """Written: lesson {number}, complete; replace its exercise by yours. Try: rlrobot-edu course check {number}
  notebooks/{name}.ipynb: the lesson
  rlrobot_course/lesson_{number}/: its exercise and figure; questions.toml beside it has the outcome of its prediction
  tests/course/test_lesson_{number}_figures.py: an oracle of its figure
Left to you: in the notebook's metadata, what the learner writes, the minutes, and the lessons that it needs; course
table writes them into docs/lessons.md. Let the last cell of notebooks/{before} lead on to it; write new symbols into
docs/notation.md, and into docs/lite/lessons.toml the numbers that are too large for a browser."""


def new_lesson(root: Path, number: str, title: str) -> str:
    """Write a lesson, and run its notebook; returns what was done, and what is left to the author.

    Raises ValueError if the number or the title cannot be one, or is taken, before anything is written.
    """
    name = f"{number}_{slug(title)}"
    refuse(root, number, title)
    lessons = lists.facts(root).items()
    before = [
        lesson.path
        for known, lesson in lessons
        if known < number and not lesson.is_optional
    ][-1]
    write_together(files_for(root, number, title, name, before))

    command = [sys.executable, "notebooks/run_all.py", f"notebooks/{name}.ipynb"]
    done = subprocess.run(command, cwd=root, capture_output=True, text=True)
    if done.returncode:
        raise ValueError(
            f"the lesson is written, but its notebook has failed: {done.stderr.strip()[-300:]}"
        )
    lists.write_table(root)
    return LEFT.format(number=number, name=name, before=before.name)


def files_for(
    root: Path, number: str, title: str, name: str, before: Path
) -> dict[Path, str]:
    """By their paths the files of the lesson: its notebook, its folder, the test of its figure, and the questions."""
    files = {}
    for source in sorted(TEMPLATE.rglob("*.txt")):
        text = (
            source.read_text(encoding="utf-8")
            .replace("NN", number)
            .replace("TITLE", title)
        )
        text = text.replace(
            "BEFORE", f"[{before.stem.replace('_', ' ')}]({before.name})"
        )
        text = text.replace('"needs": []', f'"needs": ["{before.stem[:2]}"]')
        match source.name:
            case "notebook.ipynb.txt":
                files[root / f"notebooks/{name}.ipynb"] = text
            case "test_figures.py.txt":
                files[root / f"tests/course/test_lesson_{number}_figures.py"] = text
            case "questions.toml.txt":
                files[root / QUESTIONS] = (
                    (root / QUESTIONS).read_text(encoding="utf-8") + "\n" + text
                )
            case _:
                folder = root / f"rlrobot_course/lesson_{number}"
                files[folder / source.relative_to(TEMPLATE).with_suffix("")] = text
    return files


def refuse(root: Path, number: str, title: str) -> None:
    """Raises ValueError if a lesson cannot have this number or title."""
    if not re.fullmatch(r"\d\d", number) or number == "00":
        raise ValueError(f"the number of a lesson is two digits, as 23, not {number!r}")
    if (
        number in lists.lessons(root)
        or (root / f"rlrobot_course/lesson_{number}").exists()
    ):
        raise ValueError(
            f"there is a lesson {number} already: take another number, as 23"
        )
    if not slug(title) or re.search(r"[\[\]|\n\"\\]", title):
        raise ValueError(
            f"the title of a lesson is some words without brackets, quotes, | and \\, not {title!r}"
        )


def slug(title: str) -> str:
    """The title as a part of a file's name: of "Beyond the paper" it is beyond_the_paper."""
    plain = (
        unicodedata.normalize("NFKD", title.lower()).encode("ascii", "ignore").decode()
    )
    return "_".join(re.findall(r"[a-z0-9]+", plain))
