"""Export assignments for nbgrader: `make homework`. What comes after that, docs/grading.md says."""

import argparse
import sys
from pathlib import Path

from rlrobot_edu.course.homework.nbgrader_course import export

HERE = Path(__file__).parent


def main() -> int:
    """0 if all has been written."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("notebooks", nargs="*", type=Path, help="with exercises; homework/*.ipynb if not given")
    parser.add_argument("--to", type=Path, default=HERE / "build", help="a folder; homework/build if not given")
    parser.add_argument("--seed", type=int, help="of the hidden tests, drawn if not given")
    told = parser.parse_args()
    try:
        names = export(told.notebooks or sorted(HERE.glob("*.ipynb")), told.to, told.seed)
    except (OSError, ValueError, ImportError, RuntimeError) as error:
        print(error, file=sys.stderr)
        return 1
    print(f"{told.to}: {', '.join(names)}. To hand out: what is in release/, and nothing else.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
