"""Python's small protocols: each public class answers ==, hash, in, list, len, slices, copies and repr, or says no."""

import copy
import operator
import pickle

import numpy as np
import pytest
from worlds import recording_of

import rlrobot_edu as rl
from rlrobot_edu.robots.arenas import ARENAS
from rlrobot_edu.robots.mobile_base import MobileBase
from rlrobot_edu.task.drawing import Drawing

ROWS = [(0, 0, 5.0, 1, 0), (1, 1, 0.0, 2, 0), (2, 0, -1.0, 0, 1), (0, 0, 5.0, 1, 0)]


def small_model(unseen="stay"):
    return rl.SampleModel.from_recording(recording_of(ROWS), unseen=unseen)


def learned(agent_seed=0):
    model = small_model()
    return rl.learn(
        rl.Agent(model, seed=agent_seed), rl.make_env(model, seed=1), 30, progress=False
    )


def in_the_square():
    return rl.make_env("wander_simple", seed=0)


def a_step():
    return next(rl.steps(rl.Agent("wander_simple", seed=0), in_the_square(), 1))


def a_film():
    return rl.film(rl.Agent("wander_simple", seed=0), in_the_square(), steps=2)


def a_comparison():
    return rl.compare(
        small_model(),
        ["Q+SR", "SARSA+SR"],
        repetitions=2,
        steps=20,
        progress=False,
        n_jobs=1,
    )


# Of each class: how to make one, and which protocols are its own besides those that all have. "values" are equal, and
# hashed alike, where their parts are; "sequence" and "mapping" are those of Python; "sized" has a length alone.
# "arrays" are tuples of arrays, of which NumPy
# itself says whether two are equal, number by number: they have no hash, and only the one itself is surely equal.
CLASSES = {
    "Agent": (lambda: rl.Agent("wander_simple", seed=0), ()),
    "Algorithm": (lambda: rl.Method("Q", "SR").algorithm, ("sequence", "values")),
    "Selection": (lambda: rl.Method("Q", "SR").selection, ("sequence", "values")),
    "Method": (lambda: rl.Method("Q", "SR"), ("values",)),
    "Task": (lambda: rl.load_task("wander_simple"), ("one",)),
    "InputVariable": (lambda: rl.InputVariable("x", cuts=[0.2, 0.5], unit="m"), ("values",)),
    "OutputVariable": (lambda: rl.OutputVariable("x", [-1, 1], "rad/s", ["back", "on"]), ("values",)),
    "Drawing": (lambda: Drawing("#####\n#>.G#\n#####"), ("values",)),
    "Realism": (lambda: rl.Realism(lag=0.1), ("values",)),
    "StateSpace": (lambda: rl.load_task("wander_simple").states, ("values",)),
    "Bin": (lambda: rl.load_task("wander_simple").states.decode(0)["laser_front_left"], ("values",)),
    "SampleModel": (small_model, ()),
    "Plan": (lambda: rl.value_iteration(small_model()), ()),
    "Diagnosis": (lambda: small_model().diagnose(), ("sequence", "values")),
    "Recording": (lambda: recording_of(ROWS), ("sized",)),
    "Transitions": (lambda: recording_of(ROWS).transitions, ("sequence", "arrays")),
    "History": (learned, ("sized",)),
    "Step": (a_step, ("sequence", "arrays")),
    "RobotEnv": (in_the_square, ()),
    "SampleModelEnv": (lambda: rl.make_env(small_model(), seed=0), ()),
    "MobileBase": (lambda: MobileBase("square_2x2", 1.0), ()),
    "Scene": (lambda: MobileBase("square_2x2", 1.0).scene(), ("sequence", "arrays")),
    "Solid": (lambda: ARENAS["square_2x2"].solids()[0], ("sequence", "arrays")),
    "Film": (a_film, ()),
    "Still": (lambda: rl.plot_scene(MobileBase("square_2x2", 1.0).scene()).still(), ("sequence", "values")),
    "Comparison": (a_comparison, ("mapping",)),
    "Runs": (lambda: rl.repeat(small_model(), "Q+SR", repetitions=2, steps=9, progress=False, n_jobs=1), ("sequence",)),
}  # fmt: skip


@pytest.fixture(scope="module", params=CLASSES)
def made(request):
    make, kinds = CLASSES[request.param]
    try:
        thing = make()
    except ImportError as error:
        pytest.skip(str(error))
    return request.param, thing, make, kinds


def works_or_is_refused(work):
    """What comes of it; a TypeError, which says that there is no such protocol, is as good. Nothing else is."""
    try:
        return work()
    except TypeError as error:
        assert str(error), "a refusal says something"
        return TypeError


def test_equality_gives_a_truth_value_and_agrees_with_identity_and_hash(made):
    name, thing, make, kinds = made
    assert (thing == thing) is True and (thing != thing) is False
    assert (thing == 3) is False and (thing != 3) is True and (thing == "text") is False
    if "arrays" in kinds:
        with pytest.raises(TypeError):
            hash(thing)
        return
    other = make()
    equal = thing == other
    assert equal in (True, False) and (thing != other) is not equal
    hashed = works_or_is_refused(lambda: hash(thing))
    if {"values", "one"} & {*kinds}:
        assert hashed == hash(thing) and (not equal or hash(other) == hashed)
    if "values" in kinds:
        assert equal is True, f"two of {name} with the same parts are equal"


def test_membership_iteration_length_and_slices_work_together_or_not_at_all(made):
    _, thing, _, kinds = made
    found = "arrays" not in kinds and works_or_is_refused(lambda: "Q+SR" in thing)
    several = works_or_is_refused(lambda: list(thing))
    length = works_or_is_refused(lambda: len(thing))
    if "mapping" in kinds:
        assert (
            found is True
            and len(several) == length
            and [thing[key] for key in several] == [*thing.values()]
        )
    elif "sequence" in kinds:
        assert found is False and len(several) == length == len([*reversed(thing)])
        assert all(a is b for a, b in zip(thing[:2], several[:2], strict=True))
    else:
        assert found is several is TypeError
        assert (
            works_or_is_refused(lambda: operator.getitem(thing, slice(1))) is TypeError
        )
        assert (
            length == len(ROWS) or length == 30
            if "sized" in kinds
            else length is TypeError
        )


@pytest.mark.parametrize(
    "way", [copy.copy, copy.deepcopy, lambda thing: pickle.loads(pickle.dumps(thing))]
)
def test_a_copy_is_of_the_same_kind_and_shows_itself_alike(made, way):
    _, thing, _, kinds = made
    twin = works_or_is_refused(lambda: way(thing))
    if twin is not TypeError:
        assert type(twin) is type(thing)
        same_words = repr(twin) == repr(thing) or " at 0x" in repr(thing)
        assert same_words
    if "values" in kinds:
        assert twin == thing
    if "arrays" in kinds:
        for mine, its in zip(thing, twin, strict=True):
            np.testing.assert_equal(its, mine)
