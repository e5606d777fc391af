"""Say in each lesson, each assignment and the tables of them how long it takes: ``python notebooks/minutes.py``.

A minute for 100 words, seven for an exercise of a lesson and twelve for one of an assignment, three for a prediction
and the figure that answers it, and the time that the notebook runs; rounded to five. These are the least squares
through what 25 lessons took readers with a clock, from which the rule differs by six minutes (root of the mean square).
Three old questions came later: two minutes, a guess. An open challenge has an open end, and counts nothing.
"""

import json
import re
from pathlib import Path

ROOT = Path(__file__).parents[1]
WORDS, STEP = 100, 5  # words a minute, minutes to round to
EXERCISE, PREDICTION, RECALL = {"notebooks": 7, "homework": 12}, 3, 2  # minutes
PAGE_OF = {"notebooks": "README.md", "homework": "docs/grading.md"}  # where a table tells the minutes
SENTENCE = re.compile(r"(?<=In about )\d+(?= minutes)")
REST = re.compile(r"About \d+ minutes lie behind you, about \d+ are to come")


def parts(path: Path) -> list[float]:
    """How long a notebook takes to its rest, if it has one, and from there on.

    Words in boxes that can be skipped count, too; run time as `run_all.py` found it counts in the last part.
    """
    notebook, sums = json.loads(path.read_text(encoding="utf-8")), [0.0]
    for cell in notebook["cells"]:
        text = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            if REST.search(text):
                sums.append(0.0)
            sums[-1] += len(text.split()) / WORDS
        elif "exercise" in cell["metadata"].get("tags", []):
            sums[-1] += EXERCISE[path.parent.name]
        elif " = Prediction(" in text:
            sums[-1] += PREDICTION
        elif "OldQuestions(" in text:
            sums[-1] += RECALL
    sums[-1] += notebook["metadata"].get("rlrobot_edu", {}).get("seconds", 0) / 60
    return sums


def rounded(minutes: float) -> int:
    """As it is told."""
    return STEP * round(minutes / STEP)


def main() -> None:
    """Write the minutes where they are told."""
    for folder, told_in in PAGE_OF.items():
        page = (ROOT / told_in).read_text(encoding="utf-8")
        for path in sorted((ROOT / folder).glob("*.ipynb")):
            took, notebook = parts(path), json.loads(path.read_text(encoding="utf-8"))
            n = rounded(sum(took))
            told = "About {} minutes lie behind you, about {} are to come".format(*map(rounded, (took[0], took[-1])))
            for cell in notebook["cells"]:
                if cell["cell_type"] == "markdown":
                    cell["source"] = [REST.sub(told, SENTENCE.sub(str(n), line)) for line in cell["source"]]
            path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
            page = re.sub(rf"({folder}/{path.name}\).*\| )\d+( \|)", rf"\g<1>{n}\g<2>", page)
            print(f"{n:3} minutes  {path.name}")
        (ROOT / told_in).write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
