"""The figure of lesson 00: the laser beams that count, among all that the robot has."""

from collections.abc import Mapping, Sequence

from matplotlib.collections import LineCollection

from rlrobot_course.figures.plots import GREY, RED, Picture, centred, plain
from rlrobot_edu import InputVariable, plot_scene
from rlrobot_edu.robots.scene import Scene


def plot_lasers(
    scene: Scene, readings: Mapping[str, float], inputs: Sequence[InputVariable]
) -> Picture:
    """Picture of a robot and its beams, those of `inputs` drawn thick, with their names and readings.

    readings: by the sensors' names, the lasers in the order of the scene's beams
    """
    names = [name for name in readings if name.startswith("laser")]
    counted = {variable.name for variable in inputs}
    figure = Picture(figsize=(5.6, 5.2))
    ax = figure.subplots()
    plot_scene(scene, ax)
    ax.set_title("")
    figure.headline(f"{len(counted)} of {len(names)} lasers count")
    beams = next(
        thing
        for thing in ax.collections
        if isinstance(thing, LineCollection) and thing.get_label() == "laser"
    )
    counts = [name in counted for name in names]
    beams.set(
        colors=[RED if count else GREY for count in counts],
        linewidths=[2.2 if count else 1 for count in counts],
        linestyles=["-" if count else ":" for count in counts],
    )
    for name, (start, end) in zip(names, scene.beams[:, :, :2], strict=True):
        if name in counted:
            x, y = start + 0.6 * (end - start)
            text = plain(
                f"{name.removeprefix('laser_').replace('_', ' ')}\n{readings[name]:.2f} m"
            )
            box = {
                "facecolor": "white",
                "edgecolor": RED,
                "boxstyle": "round,pad=0.2",
            }
            centred(ax, x, y, text, fontsize=8.5, bbox=box, zorder=9)
    told = ", ".join(
        f"{variable.name} {readings[variable.name]:.2f} m" for variable in inputs
    )
    figure.alt = f"The robot in its maze with {len(names)} laser beams. {len(counted)} of them are thick: {told}."
    return figure
