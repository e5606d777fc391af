#!/bin/sh
# Gradescope's setup. The zip file holds this, run_autograder and a checkout of the repository, rlrobot-edu.
set -eu
pip install -c /autograder/source/rlrobot-edu/constraints.txt '/autograder/source/rlrobot-edu[lab]'
