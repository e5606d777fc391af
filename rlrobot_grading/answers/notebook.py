"""The notebook in which a check runs, if there is one."""

from __future__ import annotations

import sys
from typing import Any


def shell() -> Any:
    """IPython's shell; None where there is none."""
    if "IPython" not in sys.modules:
        return None
    return sys.modules["IPython"].get_ipython()


def is_notebook() -> bool:
    """Whether this runs in the kernel of a notebook, where there is a learner."""
    return getattr(shell(), "kernel", None) is not None
