"""Waiting: for what a page is to show, and for anything else."""

import time


def until(page, condition: str) -> None:
    """Wait for it. Playwright's own waiting is forbidden on saved pages: no string may be run as a program there."""
    end = (
        time.monotonic() + 300
    )  # a busy machine without a graphics card draws a frame or two in a second
    while not page.evaluate(condition):
        assert time.monotonic() < end, f"waited in vain for {condition}"
        page.wait_for_timeout(20)


def eventually(condition, act=lambda: None, seconds=60.0):
    """What the condition says as soon as that is true; `act` again and again until then. For a busy machine [s]."""
    end = time.monotonic() + seconds
    while not (said := condition()):
        assert time.monotonic() < end, "it never came to be so"
        act()
        time.sleep(0.01)
    return said
