"""The options of ``python -m rlrobot_edu grade``."""

from argparse import ArgumentParser


def add_options(command: ArgumentParser) -> None:
    """Add them to the parser of the command."""
    command.add_argument("notebooks", nargs="+", metavar="NOTEBOOK", help="a notebook that was handed in")
    command.add_argument("--lesson", default="", help="its number, as in 02; looked for in each notebook if not given")
    command.add_argument("--seed", type=int, help="of the secret tapes; drawn, and told, if not given")
    command.add_argument("--seconds", type=float, default=300.0, help="for one notebook, 300 if not given")
    command.add_argument("--memory", type=int, default=4096, help="for one notebook [MiB], 4096 if not given")
    command.add_argument("--jobs", type=int, default=1, help="notebooks graded side by side, 1 if not given")
    command.add_argument("--csv", default="", metavar="FILE", help="write a table of the points")
    command.add_argument("--junit", default="", metavar="FILE", help="write JUnit's XML")
    command.add_argument("--gradescope", default="", metavar="FILE", help="write results.json, of one notebook")
