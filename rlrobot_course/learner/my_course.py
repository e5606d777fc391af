"""The learner's own copies of lessons and assignments, `my_course/`: without outputs, and never overwritten."""

import hashlib
import json
import subprocess
import sys
import time
from contextlib import suppress
from importlib.util import find_spec
from itertools import chain, count
from pathlib import Path
from typing import Any

from rlrobot_course.learner.saving import ASKED_FOR
from rlrobot_edu.checks import did_you_mean
from rlrobot_edu.files import shipped, write_whole
from rlrobot_edu.installing import to_install
from rlrobot_grading.answers.values import safely

NOTEBOOKS = shipped("notebooks")
IN_CHECKOUT = NOTEBOOKS.parent == Path(__file__).parents[2]
FOLDER = (NOTEBOOKS.parent if IN_CHECKOUT else Path.cwd()) / "my_course"
LAB = "rlrobot-edu lab"
FRESH = "rlrobot-edu fresh "
if IN_CHECKOUT and Path.cwd() == NOTEBOOKS.parent:  # make finds its file there alone
    LAB = "make lab"
    FRESH = "make fresh LESSON="
FIRST = "00_start_here.ipynb"
# What the application prefers, beside what the learner prefers: JupyterLab asks no questions about news, and what a
# widget shows is saved with the notebook, so that it is there on the next day, before any kernel runs
OPTIONS = {"--ip": "127.0.0.1", "--log-level": "ERROR"}  # unless one's own are given
PREFERENCES = {
    "@jupyterlab/apputils-extension:notification": {
        "fetchNews": "false",
        "checkForUpdates": False,
    },
    "@jupyter-widgets/jupyterlab-manager:plugin": {"saveState": True},
}

Notebook = dict[str, Any]


def open_lab(more: list[str], source: Path = NOTEBOOKS, folder: Path = FOLDER) -> int:
    """Copy the notebooks that are missing, and run JupyterLab on the copies until it ends; returns its exit code.

    more: further arguments for JupyterLab. Raises ImportError if it is not installed.
    """
    if find_spec("jupyterlab") is None:
        raise ImportError(f"JupyterLab is not installed: run {to_install('lab')}")
    print(*copy_missing(source, folder), sep="\n")
    settings = folder / ".jupyterlab"
    write_whole(settings / "overrides.json", json.dumps(PREFERENCES) + "\n")
    print(
        f"JupyterLab starts; then your browser shows {FIRST}. What you write stays in {folder}. Ctrl-C ends it."
    )
    given = [word.partition("=")[0] for word in more]
    options = [f"{name}={OPTIONS[name]}" for name in OPTIONS if name not in given]
    command = [
        sys.executable, "-m", "jupyterlab", *options, "-y",  # -y: one Ctrl-C is enough
        f"--ServerApp.root_dir={folder.parent}", f"--LabApp.app_settings_dir={settings}",
        ASKED_FOR, f"--LabApp.default_url=/lab/tree/{folder.name}/{FIRST}", *more,
    ]  # fmt: skip
    lab = subprocess.Popen(command, cwd=folder)
    is_wanted = False
    while True:
        try:
            code = lab.wait()
        except KeyboardInterrupt:
            is_wanted = True
            continue  # JupyterLab has heard it, too, and ends
        if code == 0 or is_wanted:
            print(
                f"JupyterLab has ended. Your notebooks are in {folder}; {LAB} goes on where you stopped."
            )
            return 0
        print(
            f"JupyterLab did not start, or broke off (exit code {code}): see what it says above. "
            f"Your notebooks are in {folder}.",
            file=sys.stderr,
        )
        return code


def copy_missing(source: Path = NOTEBOOKS, folder: Path = FOLDER) -> list[str]:
    """Copy each notebook that the learner does not have; returns sentences about what was done, or can be done."""
    told, copied = [], 0
    for number, (original, mine) in _originals(source, folder).items():
        edition = blank(original)
        if not mine.exists():
            write_whole(mine, _text(edition))
            copied += 1
        elif _mark(safely({}, _read, mine)) not in (_mark(edition), None):
            fresh = f"{FRESH}{number}".replace("LESSON=homework ", "HOMEWORK=")
            told.append(
                f"{mine.name} has a new edition; {fresh} gives it to you and keeps yours."
            )
    if copied:
        told.insert(0, f"{copied} notebooks were copied to {folder}.")
    return told


def set_back(lesson: str, source: Path = NOTEBOOKS, folder: Path = FOLDER) -> str:
    """Replace the learner's copy of a lesson by a fresh one; the old one goes to `old/`. Returns a sentence.

    lesson: its number, "02" or "2", or of an assignment, "homework 1"; raises ValueError if there is none of it
    """
    known = _originals(source, folder)
    name = f"0{lesson}" if f"0{lesson}" in known else lesson
    if name not in known:
        raise ValueError(
            f"there is no lesson {lesson!r}{did_you_mean(lesson, known)} The lessons are {', '.join(known)}"
        )
    original, mine = known[name]
    told = ""
    if mine.exists():
        old = _put_away(mine, folder / "old")
        told = f"; the old one is {old}"
    write_whole(mine, _text(blank(original)))
    return f"{mine} is fresh{told}."


def _put_away(mine: Path, folder: Path) -> Path:
    """Move a copy to a file of the folder that did not exist before; returns which."""
    folder.mkdir(exist_ok=True)
    stem = f"{mine.stem}_{time.strftime('%Y-%m-%d_%H-%M-%S')}"
    for ending in chain([""], (f"_{n}" for n in count(2))):
        old = folder / f"{stem}{ending}.ipynb"
        with suppress(FileExistsError):
            old.touch(exist_ok=False)  # nobody else gets this name
            return mine.replace(old)
    raise AssertionError("there is always another number")


def _originals(source: Path, folder: Path) -> dict[str, tuple[Path, Path]]:
    """By number, a notebook and the learner's copy of it: "02"; of an assignment, "homework 1", in a folder."""
    folders = (source, source / "more", source / "homework")
    paths = [path for where in folders for path in sorted(where.glob("*.ipynb"))]
    pairs = [(path, folder / path.relative_to(source)) for path in paths]
    kinds = {"homework": "homework "}
    return {
        kinds.get(path.parent.name, "") + path.name.partition("_")[0]: (path, mine)
        for path, mine in pairs
    }


def blank(path: Path) -> Notebook:
    """A notebook without outputs, marked with the edition that it was copied from."""
    notebook = _read(path)
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            cell["outputs"], cell["execution_count"] = [], None
    edition = hashlib.sha256(
        json.dumps([cell["source"] for cell in notebook["cells"]]).encode()
    ).hexdigest()[:12]
    language = {
        "codemirror_mode": {"name": "ipython", "version": 3}, "file_extension": ".py", "mimetype": "text/x-python",
        "name": "python", "nbconvert_exporter": "python", "pygments_lexer": "ipython3",
        "version": ".".join(map(str, sys.version_info[:3])),
    }  # fmt: skip
    # what JupyterLab would write on opening it, which would make it look changed
    kernel = {
        "display_name": "Python 3 (ipykernel)",
        "language": "python",
        "name": "python3",
    }
    notebook["metadata"] |= {
        "language_info": language,
        "kernelspec": kernel,
        "rlrobot_edu": {"edition": edition},
    }
    return notebook


def _mark(notebook: Notebook) -> str | None:
    """The edition from which a copy was made; None if it does not say, or is broken: it is the learner's, and stays."""
    mark = safely(None, lambda: notebook["metadata"]["rlrobot_edu"]["edition"])
    return mark if isinstance(mark, str) else None


def _read(path: Path) -> Notebook:
    notebook: Notebook = json.loads(path.read_bytes())
    return notebook


def _text(notebook: Notebook) -> str:
    return json.dumps(notebook, indent=1, ensure_ascii=False) + "\n"
