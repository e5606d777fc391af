"""Export assignments for nbgrader, or one for each student: `make homework`. What comes next: docs/grading.md."""

import argparse
import sys
from pathlib import Path

from rlrobot_grading.marking.nbgrader_course import export
from rlrobot_grading.marking.variants import export_each

HERE = Path(__file__).parent


def main() -> int:
    """0 if all has been written."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "notebooks",
        nargs="*",
        type=Path,
        help="with exercises; notebooks/homework/*.ipynb if not given",
    )
    parser.add_argument(
        "--to",
        type=Path,
        default=HERE / "build",
        help="a folder; notebooks/homework/build if not given",
    )
    parser.add_argument(
        "--seed", type=int, help="of the hidden tests, drawn if not given"
    )
    parser.add_argument(
        "--hints",
        type=int,
        choices=range(4),
        help="told for an exercise, three if not given",
    )
    parser.add_argument(
        "--rules", default="", help="TOML file that says what counts how much"
    )
    parser.add_argument(
        "--students",
        default="",
        help="CSV file of students: each gets a notebook of their own",
    )
    told = parser.parse_args()
    notebooks = told.notebooks or sorted(HERE.glob("*.ipynb"))
    try:
        if told.students:
            n = export_each(notebooks, told.to, told.students, told.hints)
            print(
                f"{told.to}: students/ holds what each of {n} gets, solutions/ is for you alone."
            )
            return 0
        names = export(notebooks, told.to, told.seed, told.hints, told.rules)
    except (OSError, ValueError, ImportError, RuntimeError) as error:
        print(error, file=sys.stderr)
        return 1
    print(
        f"{told.to}: {', '.join(names)}. To hand out: what is in release/, and nothing else."
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
