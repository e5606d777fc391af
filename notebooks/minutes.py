"""Say in each lesson and in README.md how long it takes: ``python notebooks/minutes.py``.

A minute for 100 words, six for an exercise, and the time that the notebook runs; rounded up to five.
"""

import json
import math
import re
from pathlib import Path

HERE = Path(__file__).parent
README = HERE.parent / "README.md"
WORDS, EXERCISE, STEP = 100, 6, 5  # words a minute, minutes an exercise, minutes to round to
SENTENCE = re.compile(r"(?<=In about )\d+(?= minutes)")


def minutes(notebook: dict) -> int:
    """How long a lesson takes. Words in boxes that can be skipped count, too; run time as `run_all.py` found it."""
    cells = notebook["cells"]
    words = sum(len("".join(cell["source"]).split()) for cell in cells if cell["cell_type"] == "markdown")
    exercises = sum("exercise" in cell["metadata"].get("tags", []) for cell in cells)
    run = notebook["metadata"].get("rlrobot_edu", {}).get("seconds", 0) / 60
    return STEP * math.ceil((words / WORDS + EXERCISE * exercises + run) / STEP)


def main() -> None:
    """Write the minutes where they are told."""
    page = README.read_text(encoding="utf-8")
    for path in sorted(HERE.glob("*.ipynb")):
        notebook = json.loads(path.read_text(encoding="utf-8"))
        n = minutes(notebook)
        first = notebook["cells"][0]
        first["source"] = [SENTENCE.sub(str(n), line) for line in first["source"]]
        path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
        page = re.sub(rf"(\(notebooks/{path.name}\).*\| )\d+( \|)", rf"\g<1>{n}\g<2>", page)
        print(f"{n:3} minutes  {path.name}")
    README.write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
