"""What can be typed after ``python -m rlrobot_edu grade``."""

import argparse

SYSTEMS = ("plain", "canvas", "moodle", "gradescope")
REPORTS = {
    "csv": "a table of the points",
    "gradescope": "results.json, of one notebook",
    "mistakes": "a table of what was misunderstood",
    "feedback": "a folder of sheets",
}


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the arguments of `grade` to its command."""
    add = command.add_argument
    add(
        "notebooks", nargs="+", metavar="NOTEBOOK", help="a notebook that was handed in"
    )
    add(
        "--lesson",
        default="",
        help="as 02 or assignment_1; looked for in each notebook if not given",
    )
    add("--seed", type=int, help="of the secret tapes; drawn, and told, if not given")
    add(
        "--seconds",
        type=float,
        default=300.0,
        help="for one notebook, 300 if not given",
    )
    add(
        "--memory",
        type=int,
        default=4096,
        help="for one notebook [MiB], 4096 if not given",
    )
    add(
        "--jobs",
        type=int,
        default=1,
        help="notebooks graded side by side, 1 if not given",
    )
    add(
        "--user",
        default="",
        help="run the notebooks as this user (name or number); as root, on Linux",
    )
    add(
        "--container",
        default="",
        metavar="IMAGE",
        help="run each notebook in a container of podman or docker",
    )
    add(
        "--roster",
        default="",
        metavar="CSV",
        help="students: id, and perhaps name, email, late [days]",
    )
    add(
        "--rules",
        default="",
        metavar="TOML",
        help="what counts how much: points, partial, hint_off, late_off",
    )
    add(
        "--for",
        dest="system",
        choices=SYSTEMS,
        default="plain",
        help="what --csv is written for, plain if not given",
    )
    for report, what in REPORTS.items():
        add(f"--{report}", default="", metavar="PATH", help=f"write {what}")
