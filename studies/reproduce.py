"""Run the paper's experiments, write docs/reproduction/: ``studies/reproduce.py [--quick | --page | --curves]``."""

from argparse import ArgumentParser
from pathlib import Path

from paper.report import write_page
from paper.run import SEED, draw_curves, reproduce
from results_page import write_results

if __name__ == "__main__":
    parser = ArgumentParser(description=__doc__)
    parser.add_argument(
        "--quick",
        action="store_true",
        help="few repetitions, into docs/reproduction/quick/",
    )
    parser.add_argument(
        "--engine",
        default="",
        help="of the robots, as kinematic; into a folder of its own",
    )
    parser.add_argument(
        "--seed",
        type=int,
        default=SEED,
        help="of all comparisons; another one than the report's writes into a folder of its own",
    )
    parser.add_argument(
        "--page",
        action="store_true",
        help="run nothing; write the tables anew from averages.csv",
    )
    parser.add_argument(
        "--curves",
        nargs="*",
        metavar="KEY",
        help="draw learning curves anew, such as that of robot_wander_1k; by default all. Runs are taken from results/",
    )
    given = parser.parse_args()
    if given.page:
        write_page(Path("docs/reproduction"), {}, has_prose=True)
    elif given.curves is not None:
        draw_curves(given.curves)
    else:
        reproduce(given.quick, engine=given.engine, seed=given.seed)
    is_report = not given.quick and not given.engine and given.seed == SEED
    if is_report:
        write_results()
