"""The progress bar of whatever may take long."""

import os
import sys
from typing import Any

if sys.platform == "emscripten":  # in a browser tqdm does not see that it is in a notebook,
    from tqdm.notebook import tqdm

    tqdm.monitor_interval = 0  # and would warn that no thread watches its bars
else:
    from tqdm.auto import tqdm


def progress_bar(total: int, shown: bool, delay: float = 1, **about: Any) -> Any:
    """A bar that comes when something is done after `delay` seconds, or at once with 0, and leaves nothing behind.

    There is none where RLROBOT_EDU_PROGRESS is 0, as it is while the course's notebooks are run to be saved.
    """
    shown = shown and os.environ.get("RLROBOT_EDU_PROGRESS") != "0"
    return tqdm(total=total, delay=delay, leave=False, disable=not shown, **about)
