"""The progress bar of whatever may take long."""

import os
import sys
from typing import Any

from tqdm.auto import tqdm

if sys.platform == "emscripten":  # a browser has no threads, and tqdm would warn that none watches its bars
    tqdm.monitor_interval = 0


def progress_bar(total: int, shown: bool, **about: Any) -> Any:
    """A bar that comes after a second and leaves nothing behind.

    There is none where RLROBOT_EDU_PROGRESS is 0, as it is while the course's notebooks are run to be saved.
    """
    shown = shown and os.environ.get("RLROBOT_EDU_PROGRESS") != "0"
    return tqdm(total=total, delay=1, leave=False, disable=not shown, **about)
