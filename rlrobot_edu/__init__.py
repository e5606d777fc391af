"""RLROBOT-EDU: tabular reinforcement learning on simulated robots, to read, to run and to watch.

    import rlrobot_edu as rl

``__init__.pyi`` lists the public names and their files; they load when they are first used, so importing the package
is quick. Whatever else a folder holds is imported from its module, as in
``from rlrobot_edu.learning.history import History``. Where to begin reading:

environments  `make_env`, with which most programs begin
task/         what a robot senses, does and is rewarded for
learning/     algorithms and selections, a file each; the agent, its memory, the loop
robots/       the environment of a task: robots, arenas, realism; arm/, engines/
models/       recordings and sample models, what they do not know, value iteration
experiments/  repetitions, comparisons, statistics
show/         curves, films, views from above; in3d/

Below it, for all: checks.py (arguments and error messages), keywords.py (misspelt ones), files.py (written whole or not
at all), installing.py (what brings a missing package), seeds.py, and jit/ (the compiler of the kernels).

On top of this core:

widgets/      what a notebook shows and a learner touches
tools/        new-task, check-task and doctor

Real robots are in the package `rlrobot_ros`.
"""

import sys
from types import SimpleNamespace

# Gymnasium imports locks between processes, which a browser does not have.
if sys.platform == "emscripten":

    class _NoLock:
        SEM_VALUE_MAX = 0

        def __init__(self, *_: object) -> None:
            raise OSError(
                "in a browser there is one process, and no lock between several"
            )

    sys.modules.setdefault(
        "_multiprocessing", SimpleNamespace(SemLock=_NoLock, sem_unlink=None)
    )  # type: ignore[arg-type]

import gymnasium
import lazy_loader

from rlrobot_edu.missing_names import MissingModules, no_such_name, without_extra
from rlrobot_edu.task.task_file import available_tasks as _available_tasks
from rlrobot_edu.version import __version__ as __version__

_load, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
sys.meta_path.append(MissingModules(__all__))


def __getattr__(name: str) -> object:
    """A public name, which loads now; of any other, an AttributeError says where it is."""
    if name in __all__:
        try:
            return _load(name)
        except ImportError as missing:
            return without_extra(missing)
    raise no_such_name(name, __all__)


for _name in _available_tasks():
    gymnasium.register(
        f"rlrobot/{_name}-v0",
        "rlrobot_edu.environments:make_env",
        kwargs={"task": _name},
    )
