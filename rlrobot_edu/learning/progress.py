"""The progress bar of whatever may take long."""

import os
import sys
from typing import Any

if (
    sys.platform == "emscripten"
):  # in a browser tqdm does not see that it is in a notebook,
    from tqdm.notebook import tqdm

    tqdm.monitor_interval = 0  # and would warn that no thread watches its bars
else:
    from tqdm.auto import tqdm


class Interrupted(KeyboardInterrupt):
    """Ctrl-C, which a notebook tells in one line."""

    def _render_traceback_(self) -> list[str]:
        return [str(self)]


def watched() -> bool:
    """Whether anybody may look on; not where RLROBOT_EDU_PROGRESS is 0, as while notebooks are run to be saved."""
    return os.environ.get("RLROBOT_EDU_PROGRESS") != "0"


def progress_bar(total: int, shown: bool, delay: float = 1, **about: Any) -> Any:
    """A bar that comes when something is done after `delay` seconds, or at once with 0, and leaves nothing behind.

    There is none where nobody is to look on.
    """
    return tqdm(
        total=total,
        delay=delay,
        leave=False,
        disable=not (shown and watched()),
        **about,
    )
