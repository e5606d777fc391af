"""What a chat bot's first answers are worth: judges `chat_bot` and writes the table of docs/ai_assistants.md.

``python studies/ai_assistants.py`` takes half a minute.
"""

from collections import Counter
from importlib import import_module
from pathlib import Path

from chat_bot import assignments, lessons
from made_blocks import filled

from rlrobot_edu.files import write_whole

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs/ai_assistants.md"
KINDS = ("right", "wrong", "waiting")
HEAD = "| exercises of | right at once | wrong | no answer |\n|---|---:|---:|---:|\n"


def verdicts() -> dict[str, str]:
    """What the checks say of each exercise's answer, by names such as "lesson_03 update"; "waiting" without one."""
    found = {}
    for folder in sorted((ROOT / "rlrobot_course").glob("*_*/exercises.py")):
        name = folder.parent.name
        kind, _, number = name.partition("_")
        answers = lessons if kind == "lesson" else assignments
        check = import_module(f"rlrobot_course.{name}.exercises").check
        for exercise, judge in vars(check).items():
            answer = getattr(answers, f"{kind[0]}{number}_{exercise}", None)
            found[f"{name} {exercise}"] = judge(answer).status
    return found


def group(name: str) -> str:
    """Where an exercise is counted."""
    if name.startswith("assignment"):
        return "assignments 1 to 5"
    return f"lessons {'01 to 10' if name <= 'lesson_11' else '11 to 22'}"


def table(found: dict[str, str]) -> str:
    """The table, in Markdown, and which answers are missing from it."""
    counts = Counter((group(name), status) for name, status in found.items())
    rows = ""
    for one in dict.fromkeys(group(name) for name in sorted(found, reverse=True)):
        cells = " | ".join(str(counts[one, kind]) for kind in KINDS)
        rows = f"| {one} | {cells} |\n" + rows
    cells = " | ".join(str(list(found.values()).count(kind)) for kind in KINDS)
    text = f"{HEAD}{rows}| **all** | {cells} |\n"
    for status, words in (("wrong", "Wrong"), ("waiting", "No answer")):
        names = [name.partition("_")[2] for name in found if found[name] == status]
        text += f"\n{words}: {', '.join(names)}.\n"
    return text


def written(page: str, found: dict[str, str]) -> str:
    """The page with the table in its place."""
    return filled(page, {"table": table(found).strip()})


if __name__ == "__main__":
    write_whole(PAGE, written(PAGE.read_text(encoding="utf-8"), verdicts()))
