"""Say in each lesson, each assignment and the tables of them how long it takes: ``python notebooks/minutes.py``.

A minute for 100 words, six for an exercise of a lesson and twelve for one of an assignment, and the time that the
notebook runs; rounded up to five.
"""

import json
import math
import re
from pathlib import Path

ROOT = Path(__file__).parents[1]
WORDS, STEP = 100, 5  # words a minute, minutes to round to
EXERCISE = {"notebooks": 6, "homework": 12}  # minutes
PAGE_OF = {"notebooks": "README.md", "homework": "docs/grading.md"}  # where a table tells the minutes
SENTENCE = re.compile(r"(?<=In about )\d+(?= minutes)")


def minutes(path: Path) -> int:
    """How long a notebook takes. Words in boxes that can be skipped count, too; run time as `run_all.py` found it."""
    notebook = json.loads(path.read_text(encoding="utf-8"))
    cells = notebook["cells"]
    words = sum(len("".join(cell["source"]).split()) for cell in cells if cell["cell_type"] == "markdown")
    exercises = sum("exercise" in cell["metadata"].get("tags", []) for cell in cells)
    run = notebook["metadata"].get("rlrobot_edu", {}).get("seconds", 0) / 60
    return STEP * math.ceil((words / WORDS + EXERCISE[path.parent.name] * exercises + run) / STEP)


def main() -> None:
    """Write the minutes where they are told."""
    for folder, told_in in PAGE_OF.items():
        page = (ROOT / told_in).read_text(encoding="utf-8")
        for path in sorted((ROOT / folder).glob("*.ipynb")):
            n, notebook = minutes(path), json.loads(path.read_text(encoding="utf-8"))
            first = notebook["cells"][0]
            first["source"] = [SENTENCE.sub(str(n), line) for line in first["source"]]
            path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
            page = re.sub(rf"({folder}/{path.name}\).*\| )\d+( \|)", rf"\g<1>{n}\g<2>", page)
            print(f"{n:3} minutes  {path.name}")
        (ROOT / told_in).write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
