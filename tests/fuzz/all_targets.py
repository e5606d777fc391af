"""All targets by name."""

from __future__ import annotations

from fuzz import describing, files, learning, seeds, surroundings, task_files, things
from fuzz.contract import limit_memory
from fuzz.targets import Target

MODULES = (files, learning, describing, surroundings, task_files)
TARGETS: dict[str, Target] = {
    target.name: target for module in MODULES for target in module.TARGETS
}


def warm_up() -> None:
    """Compile, load and draw once what takes long the first time; from then on memory and time are watched."""
    seeds.files()
    things.usable_model(seeds.model())
    things.usable_comparison(things._undisturbed())
    things.drawn(things.rl.plot_learning(seeds.history()))
    limit_memory()
