import sys
from pathlib import Path

import pytest

import rlrobot_edu as rl

sys.path.insert(0, str(Path(__file__).parents[1] / "docs"))  # pages with something to compute are scripts there


@pytest.fixture(scope="session")
def vrep():
    """The paper's own recording of wander_1k."""
    from vrep_comparison import VREP, vrep_recording

    if not VREP.is_file():
        pytest.skip("the recording of the paper's authors is not here (it is not part of the project)")
    return vrep_recording()


@pytest.fixture(scope="session")
def wander_model():
    """The sample model of the toolkit's own wander_1k dataset."""
    return rl.SampleModel.from_recording(rl.read_recording("wander_1k"))
