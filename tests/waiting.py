"""Waiting for what a page is to show."""

import time


def until(page, condition: str) -> None:
    """Wait for it. Playwright's own waiting is forbidden on saved pages: no string may be run as a program there."""
    end = time.monotonic() + 300  # a busy machine without a graphics card draws a frame or two in a second
    while not page.evaluate(condition):
        assert time.monotonic() < end, f"waited in vain for {condition}"
        page.wait_for_timeout(20)
