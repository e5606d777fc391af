"""Notebooks are run without progress bars, as they are saved: what a bar writes differs from run to run."""

import os

os.environ["RLROBOT_EDU_PROGRESS"] = "0"
