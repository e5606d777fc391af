"""Run the paper's experiments and write docs/reproduction/: ``python studies/reproduce.py [--quick]``."""

from argparse import ArgumentParser

from paper.run import reproduce

if __name__ == "__main__":
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="few repetitions, into docs/reproduction/quick/")
    parser.add_argument("--engine", default="", help="of the robots, as kinematic; into a folder of its own")
    reproduce(**vars(parser.parse_args()))
