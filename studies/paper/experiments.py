"""The set-ups: every comparison that is run here."""

from collections.abc import Callable, Mapping
from functools import partial
from typing import NamedTuple

from paper.paper import THREE, TUKEY, PaperPair
from paper.worlds import without_lucky_loops
from rlrobot_course.lesson_13.contact import contact_alone
from rlrobot_edu.learning.history import History
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.robots.realism import Realism
from rlrobot_edu.task.task import Task


class Length(NamedTuple):
    """How long a learning process lasts."""

    number: int
    unit: str = "steps"

    def __str__(self) -> str:
        return f"{self.number} {self.unit if self.number > 1 else self.unit.removesuffix('s')}"

    def beginning(self, history: History) -> History:
        """The process as it would have been with this length: the same agent, stopped sooner.

        What the agent had learned stays that of the whole process; its time is taken to be in proportion.
        """
        n = self.number
        if self.unit == "episodes":
            ends = (history.terminated | history.truncated).nonzero()[0]
            n = int(ends[min(n, len(ends)) - 1]) + 1
        seconds = history.seconds * n / len(history)
        return History(
            history.method,
            history.transitions.part(slice(n)),
            history.learned,
            seconds,
            history.size,
        )


class Experiment(NamedTuple):
    """One comparison.

    key, title: its name in files, and in words
    task: its name; on_model: in a sample model of it, or else on the robot
    methods: as in `compare`; repetitions: of the full set, and of the quick one
    lengths: all at which it is judged. The longest, the last one, is run: the others are its beginnings
    pairs: what the paper says of pairs of methods; best: which value it chose
    change: makes another world of the task or of its model, to show a cause
    seed: of the recording that the model is made of; None is the toolkit's own recording
    faulty: Q-learning is run once more with the fault of the paper's program
    realism: of the robot; None is the ideal one
    """

    key: str
    title: str
    task: str
    on_model: bool
    methods: Mapping[str, Mapping] | tuple[str, ...]
    repetitions: tuple[int, int]
    lengths: tuple[Length, ...] = (Length(3600),)
    pairs: tuple[PaperPair, ...] = ()
    best: str | None = None
    change: Callable[[Task | SampleModel], Task | SampleModel] | None = None
    seed: int | None = None
    faulty: bool = False
    realism: Realism | None = None


def sweep(
    name: str,
    symbol: str,
    values: tuple[float, ...],
    more: Callable[[float], dict] = lambda x: {},
) -> dict:
    """Methods by label: TOSL+SR with each of these values of one parameter, and what `more` adds."""
    return {
        f"{symbol} = {value:g}": {"method": "TOSL+SR", name: value, **more(value)}
        for value in values
    }


_GAMMAS = (0.5, 0.8, 0.9, 0.95)
# Softmax divides Q by Qmax = Rmax / (1 − γ), so γ sets the temperature, too. With this Rmax, Qmax is 100 for every γ.
_SAME_TEMPERATURE = sweep(
    "gamma", "γ", _GAMMAS, lambda gamma: {"r_max": 100 * (1 - gamma)}
)
PRELIMINARIES = (
    ("algorithms", "Which algorithm?", ("TOSL+SR", "SL+SR", "SARSA+SR", "Q+SR"), "TOSL+SR"),
    ("lambda", "How long a trace?", sweep("lam", "λ", (0, 0.3, 0.5, 0.7, 0.9, 0.95)), "λ = 0.9"),
    ("alpha", "How fast to learn?", sweep("alpha", "α", (0.03, 0.1, 0.3, 0.5)), "α = 0.1"),
    ("gamma", "How far to look ahead?", sweep("gamma", "γ", _GAMMAS), "γ = 0.9"),
    ("gamma_alone", "How far to look ahead, at one temperature?", _SAME_TEMPERATURE, "γ = 0.9"),
    ("temperature", "How hot?", sweep("temperature", "T", (0.3, 1, 3, 10)), "T = 1"),
    ("exploration", "How to explore?", ("TOSL+SR", "TOSL+EG"), "TOSL+SR"),
)  # fmt: skip

# Values that are tried once more where walls hold the robot, λ with the paper's method, too
WITH_WALLS = [
    one
    for one in PRELIMINARIES
    if one[0] in ("lambda", "alpha", "gamma", "temperature")
]
_LAMBDA = PRELIMINARIES[1]
_OF_QBIASSR = {
    label: its | {"method": "TOSL+QBIASSR"} for label, its in _LAMBDA[2].items()
}
WITH_WALLS.append(("lambda_qbiassr", _LAMBDA[1], _OF_QBIASSR, _LAMBDA[3]))


def _preliminary(
    on_model: bool, key: str, title: str, methods, best: str
) -> Experiment:
    pairs = (
        ()
        if "=" in best
        else tuple(PaperPair(best, other) for other in methods if other != best)
    )
    key, title = (
        f"preliminary_{key}",
        f"{title} On {'the sample model' if on_model else 'the robot'}",
    )
    repetitions = (1000, 50) if on_model else (30, 4)
    key += "" if on_model else "_robot"
    return Experiment(
        key,
        title,
        "wander_1k",
        on_model,
        methods,
        repetitions,
        pairs=pairs,
        best=None if pairs else best,
    )


# Learning processes last from 1 to 60 minutes in the paper, which does not say which: so several lengths are run where
# it matters, and all are shown. A step takes a second; an episode of an arm has 120 steps, one of navigation 3600.
_ARM = (Length(60), *(Length(n, "episodes") for n in (1, 3, 10, 30)))
_NAVIGATION = tuple(Length(n, "episodes") for n in (1, 3, 5, 10))
LENGTHS = {
    "wander_simple": (Length(60), Length(300)), "arm_1k": _ARM, "arm_4k": _ARM, "navigation_1k": _NAVIGATION,
    "giraff_wander_simple": (Length(60),), "giraff_wander_1k": (Length(1800),), "giraff_wander_4k": (Length(1800),),
}  # fmt: skip
_HOUR = (Length(3600),)
_ON_MODELS = ("wander_simple", "wander_1k", "arm_1k", "navigation_1k")
_ON_ROBOTS = (
    "wander_simple", "wander_1k", "wander_4k", "arm_1k", "arm_4k", "navigation_1k",
    "giraff_wander_simple", "giraff_wander_1k", "giraff_wander_4k",
)  # fmt: skip
_ON_ROBOT = {"wander_simple": (100, 30), "arm_1k": (30, 3), "arm_4k": (30, 3)}
_TRACES = {
    traces: {"method": "TOSL+SR", "traces": traces} for traces in ("reduced", "full")
}
FAULTY = "Q+SR with the fault"
HELD = (
    "wander_1k",
    "wander_4k",
)  # tasks that are run once more with friction and lag as in V-REP
ARMS = (
    "arm_1k",
    "arm_4k",
)  # tasks that are run once more with another reward, and without traces
_WITHOUT_TRACES = {label: {"method": label, "lam": 0.0} for label in THREE}
RECORDINGS = (1, 2, 3)  # seeds of further recordings of wander_1k
CUT = (
    "uniform",
    "siblings",
    "stay",
)  # what an unknown pair does in a model without its lucky loops
EVADED = (
    "wander_simple",
    "wander_1k",
    "wander_4k",
    "giraff_wander_1k",
)  # with loop evasion as in the paper's program
_EVASION_IN_QBIASSR = {
    label: {"method": label, "loop_evasion": label.endswith("QBIASSR")}
    for label in THREE
}
_ALONE = {
    "friction": Realism(wall_friction=Realism.vrep().wall_friction),
    "lag": Realism(lag=Realism.vrep().lag),
}

EXPERIMENTS = (
    *(_preliminary(on_model, *one) for one in PRELIMINARIES for on_model in (True, False)),
    *(
        Experiment(
            f"model_{task}", f"On a sample model: {task}", task, True, THREE,
            (200, 20) if task == "navigation_1k" else (1000, 50), LENGTHS.get(task, _HOUR),
        )
        for task in _ON_MODELS
    ),
    *(
        Experiment(
            f"robot_{task}", f"Physical simulation: {task}", task, False, THREE, _ON_ROBOT.get(task, (30, 4)),
            LENGTHS.get(task, _HOUR), pairs=TUKEY.get(task, ()),
        )
        for task in _ON_ROBOTS
    ),
    Experiment(
        "traces", "Reduced against full traces", "wander_1k", True, _TRACES, (1000, 50), (Length(600),),
    ),
    Experiment(
        "cause_fault", "Q-learning with the fault of the paper's program", "wander_1k", True, ("TOSL+SR", "Q+SR"),
        (200, 20), faulty=True,
    ),
    *(
        Experiment(
            f"cause_loops_{unseen}", f"The sample model without its lucky loops, unknown pairs: {unseen}", "wander_1k",
            True, ("TOSL+SR", "Q+SR"), (1000, 50), change=partial(without_lucky_loops, unseen=unseen),
        )
        for unseen in CUT
    ),
    *(
        Experiment(
            f"cause_recording_{seed}", f"A sample model of another recording ({seed})", "wander_1k", True, THREE,
            (200, 20), seed=seed,
        )
        for seed in RECORDINGS
    ),
    *(
        Experiment(
            f"cause_walls_{task}", f"Walls that hold the robot: {task}", task, False, THREE, (30, 4), pairs=TUKEY[task],
            realism=Realism.vrep(),
        )
        for task in HELD
    ),
    *(
        Experiment(
            f"cause_{name}_wander_1k", f"V-REP's {name} alone: wander_1k", "wander_1k", False, THREE[1:], (30, 4),
            pairs=TUKEY["wander_1k"][2:], realism=realism,
        )
        for name, realism in _ALONE.items()
    ),
    _preliminary(False, *PRELIMINARIES[0])._replace(
        key="cause_walls_algorithms", title="Walls that hold the robot: which algorithm?", realism=Realism.vrep(),
    ),
    *(
        _preliminary(False, *one)._replace(
            key=f"cause_walls_{one[0]}", title=f"Walls that hold the robot: {one[1]}", realism=Realism.vrep(),
            repetitions=(12, 4),
        )
        for one in WITH_WALLS
    ),
    *(
        Experiment(
            f"cause_contact_{task}", f"The arm, rewarded for contact alone: {task}", task, False, THREE, (30, 3),
            LENGTHS[task], TUKEY[task], change=contact_alone,
        )
        for task in ARMS
    ),
    *(
        Experiment(
            f"cause_traces_{task}", f"The arm, without traces: {task}", task, False, _WITHOUT_TRACES, (30, 3),
            LENGTHS[task], TUKEY[task],
        )
        for task in ARMS
    ),
    *(
        Experiment(
            f"cause_evasion_{task}", f"Loop evasion in QBIASSR alone: {task}", task, False, _EVASION_IN_QBIASSR,
            _ON_ROBOT.get(task, (30, 4)), LENGTHS.get(task, _HOUR), pairs=TUKEY[task],
        )
        for task in EVADED
    ),
)  # fmt: skip


def by_key(key: str) -> Experiment:
    """The experiment of this name."""
    return next(experiment for experiment in EXPERIMENTS if experiment.key == key)
