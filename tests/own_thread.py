"""For tests that run an event loop: in the first thread, that of an open browser may be running."""

import functools
from concurrent.futures import ThreadPoolExecutor


def in_a_thread(test):
    """Let a test run in a thread of its own."""

    @functools.wraps(test)
    def in_a_thread_of_its_own(*arguments, **more):
        with ThreadPoolExecutor(1) as pool:
            pool.submit(test, *arguments, **more).result()

    return in_a_thread_of_its_own
