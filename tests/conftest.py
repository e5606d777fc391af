"""What all tests share: a home of their own, the slow files first, and the recordings and models they learn from."""

import os
import shutil
import signal
import sys
import tempfile
import threading
import time
from pathlib import Path

import hypothesis
import numpy as np
import pytest
from hypothesis.internal.conjecture import providers

# Before the library is imported: no test, and nothing that a test starts, reads or changes the settings and caches in
# the home of the person who runs it. (The workers of pytest-xdist are started by a process that has been here.)
if "PYTEST_XDIST_WORKER" not in os.environ:
    _home = tempfile.TemporaryDirectory(
        prefix="rlrobot-tests-", ignore_cleanup_errors=True
    )
    os.environ["RLROBOT_TESTS_USERS_HOME"] = str(
        Path("~").expanduser()
    )  # pip's settings are there
    os.environ["HOME"] = os.environ["USERPROFILE"] = _home.name
    for _name in (
        "XDG_CONFIG_HOME",
        "XDG_CACHE_HOME",
        "XDG_DATA_HOME",
        "XDG_STATE_HOME",
    ):
        os.environ.pop(_name, None)
    os.environ["OPENBLAS_NUM_THREADS"] = (
        "1"  # or each of hundreds of processes would start threads that wait busily
    )
    import matplotlib.font_manager  # noqa: F401 - lists the fonts once; if a notebook did, it might say so

import rlrobot_edu as rl

# An example's time tells of the machine, and what failed once must fail again; `make fuzz` tries other examples.
hypothesis.settings.register_profile(
    "steady",
    deadline=None,
    derandomize=True,
    suppress_health_check=[hypothesis.HealthCheck.too_slow],
)
hypothesis.settings.load_profile("steady")
# It would also draw constants of all modules that are loaded; these are others in each worker, so luck would decide.
providers._get_local_constants = lambda: providers._local_constants

# If the tests are started in the background, they may ignore Ctrl-C, and so would every process that they start.
if (
    signal.getsignal(signal.SIGINT) == signal.SIG_IGN
    and threading.current_thread() is threading.main_thread()
):
    signal.signal(signal.SIGINT, signal.default_int_handler)

for _folder in (
    "studies",
    "docs/site",
):  # these folders contain scripts that compute pages
    sys.path.insert(0, str(Path(__file__).parents[1] / _folder))

# No connections to other servers. WebGL without a graphics card, for pages that use it: drawn that way, others would
# keep two processors busy while they move
BROWSER_FLAGS = (
    "--no-sandbox --disable-gpu --enable-unsafe-swiftshader --disable-quic "
    "--no-first-run --disable-background-networking --disable-component-update --disable-sync"
)
# The slowest first
SLOW_FILES = [
    "release",
    "browser",
    "lite",
    "site",
    "grade",
    "platforms",
    "howto",
    "base_tasks",
    "workshop",
    "compiled_loop",
    "show",
    "pages",
    "agent",
    "notebooks",
]


# `make test` leaves to `make test-all` what is marked as long: it takes over three seconds. So does all that is here.
LONG = ("tests/browser", "tests/release", "tests/ros", "notebooks")
QUICK_NOTEBOOK = "03_q_learning.ipynb"
NOT_NOW = pytest.mark.skip(reason="make test-all LONG=1 runs this one, too")


@pytest.hookimpl(wrapper=True)
def pytest_xdist_auto_num_workers():
    """One more than there are processors: many tests wait, for a browser or for another process."""
    return (yield) + 1


@pytest.hookimpl(tryfirst=True)  # before those that are not asked for are left out
def pytest_collection_modifyitems(items):
    """Slow files first, then notebooks, then the rest: no worker is left alone with a slow file at the end."""
    for item in items:
        where = item.path.relative_to(item.config.rootpath).as_posix()
        if where.startswith(LONG) and item.path.name != QUICK_NOTEBOOK:
            item.add_marker("long")
        if item.get_closest_marker("nightly") and "RLROBOT_EDU_LONG" not in os.environ:
            item.add_marker(NOT_NOW)
    rank = {f"test_{name}.py": i for i, name in enumerate(SLOW_FILES)}
    items.sort(
        key=lambda item: rank.get(
            item.path.name, len(rank) + (item.path.suffix != ".ipynb")
        )
    )


@pytest.fixture(scope="session")
def vrep():
    """The paper's own recording of wander_1k."""
    from vrep_comparison import VREP, vrep_recording

    if not VREP.is_file():
        pytest.skip(
            "the recording of the paper's authors is not here (it is not part of the project)"
        )
    return vrep_recording()


@pytest.fixture(scope="session")
def wander_model():
    """The sample model of the toolkit's own wander_1k dataset."""
    return rl.SampleModel.from_recording(rl.read_recording("wander_1k"))


@pytest.fixture(scope="session")
def episodes_model():
    """A walk along four states; the goal is at its end, an episode has at most eight steps."""
    from worlds import recording_of

    rows = [
        (s, a, 5.0 if s + a == 4 else 0.0, min(s + a, 3), s + a == 4)
        for s in range(4)
        for a in (0, 1)
    ]
    model = rl.SampleModel.from_recording(
        recording_of(rows, shape=(2, 2)), unseen="stay"
    )
    return rl.SampleModel(
        **{**vars(model), "episode_steps": 8, "starts": np.array([0])}
    )


@pytest.fixture(scope="module")
def browser():
    """A headless Chromium. Not one for all files: while it is open, the thread's event loop runs."""
    playwright = pytest.importorskip(
        "playwright.sync_api", reason="needs playwright to drive a browser"
    )
    chromium = shutil.which("chromium") or pytest.skip(
        "needs chromium; CI installs it (apt install chromium)"
    )
    with playwright.sync_playwright() as p:
        browser = p.chromium.launch(
            executable_path=chromium, args=BROWSER_FLAGS.split(), timeout=300_000
        )
        yield browser
        browser.close()


@pytest.fixture
def nothing_is_left_running():
    """Afterwards, every thread that the test began has ended."""
    before = set(threading.enumerate())
    yield
    deadline = time.monotonic() + 60
    while set(threading.enumerate()) - before:
        assert time.monotonic() < deadline, threading.enumerate()
        time.sleep(0.01)
