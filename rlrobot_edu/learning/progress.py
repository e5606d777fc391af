"""The progress bar of anything that may take long."""

import os
import sys
from typing import Any

if sys.platform == "emscripten":
    # In a browser tqdm does not notice that it is in a notebook, and it would warn that no thread watches its bars.
    from tqdm.notebook import tqdm

    tqdm.monitor_interval = 0
else:
    from tqdm.auto import tqdm


class Interrupted(KeyboardInterrupt):
    """Ctrl-C, which a notebook shows in one line."""

    def _render_traceback_(self) -> list[str]:
        return [str(self)]


def watched() -> bool:
    """Whether somebody may be watching. Not if RLROBOT_EDU_PROGRESS is 0, as when notebooks are run to be saved."""
    return os.environ.get("RLROBOT_EDU_PROGRESS") != "0"


def progress_bar(total: int, shown: bool, delay: float = 1, **about: Any) -> Any:
    """A progress bar that appears after `delay` seconds and leaves nothing behind.

    It stays hidden if it is not `shown`, or if nobody is watching.
    """
    return tqdm(
        total=total,
        delay=delay,
        leave=False,
        disable=not (shown and watched()),
        **about,
    )
