"""What can be typed after ``rlrobot-edu grade``."""

import argparse

TEXTS = {
    "lesson": "as 02 or assignment_1; looked for in each notebook if not given",
    "user": "run the notebooks as this user, by name or number; for root on Linux",
    "container": "run each notebook in a container with this image, by podman or docker",
    "roster": "list of students, CSV: id, and perhaps name and late [days]",
    "rules": "what counts how much, TOML: points, partial, hint_off, late_off",
    "csv": "write a table of the points",
    "mistakes": "write a table of what was misunderstood",
    "feedback": "write a folder with a sheet for each student",
}


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the arguments of `grade` to its command."""
    add = command.add_argument
    add("notebooks", nargs="+", metavar="NOTEBOOK", help="a file, a folder, a pattern")
    for name, meaning in TEXTS.items():
        add(f"--{name}", default="", help=meaning)
    add("--trust", action="store_true", help="run the notebooks with your own rights")
    add("--seed", type=int, help="of the secret tapes; drawn, and shown, if not given")
    add("--seconds", type=float, default=300.0, help="for one notebook, 300")
    add("--memory", type=int, default=4096, help="for one notebook [MiB], 4096")
    add("--jobs", type=int, default=1, help="notebooks graded at the same time, 1")
