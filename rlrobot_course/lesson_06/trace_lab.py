"""A laboratory: draw the visits to one pair, drag α and λ, and see three kinds of trace and what they teach."""

from collections.abc import Sequence

import ipywidgets
import numpy as np

from rlrobot_course.lesson_06.figures import LOOK, trace_over_time
from rlrobot_course.lesson_06.forward_view import TRACES, online_lambda_return, replay
from rlrobot_course.plots import BLACK, GREY, VERMILION, Picture
from rlrobot_edu.learning.size import Size
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.widgets.live_picture import LivePicture
from rlrobot_edu.widgets.page_script import NamedHandles

GAMMA = 0.9


class TraceLab(Displayed):
    """Eleven seconds of driving: a button for each second says whether the robot is in the pair that we look at.

    A second in the pair pays 10, one elsewhere 0; in the last one the robot bumps, which pays −2.

    visits: whether it is in the pair, list (n,); alpha, lam: where the sliders stand first
    """

    def __init__(self, visits: Sequence[bool] = (True,) * 8 + (False,) * 2 + (True,), alpha: float = 0.5,
                 lam: float = 0.9) -> None:  # fmt: skip
        self.visits = [
            ipywidgets.ToggleButton(value=there, description=str(t), tooltip=f"in the pair in second {t}",
                                    layout={"width": "3em"})
            for t, there in enumerate(visits, 1)
        ]  # fmt: skip
        look = {"style": {"description_width": "max-content"}, "layout": {"width": "32em", "max_width": "100%"}}
        self.alpha = ipywidgets.FloatSlider(alpha, min=0.05, max=1, step=0.05, description="α (alpha)", **look)
        self.lam = ipywidgets.FloatSlider(lam, min=0, max=1, step=0.05, description="λ (lambda)", **look)
        self._image = LivePicture(self.picture)
        row = ipywidgets.Box(self.visits, layout={"flex_flow": "row wrap"})
        told = ipywidgets.HTML("In the pair in second …")
        self.widget = ipywidgets.VBox([NamedHandles(), told, row, self.alpha, self.lam, self._image.widget])
        for control in (*self.visits, self.alpha, self.lam):
            control.observe(lambda _: self._image.update(), "value")

    def picture(self) -> Picture:
        """The traces and the values for what is chosen now."""
        return plot_lab([button.value for button in self.visits], self.alpha.value, self.lam.value)

    def still(self) -> Still:
        """The picture as it is now."""
        return self._image.still()

    def __repr__(self) -> str:
        return f"<TraceLab: {self._image.still().alt}>"


def drive(visits: Sequence[bool]) -> list[tuple]:
    """The steps (s, a, r, s', a', terminated) of a drive that ends with a bump; state 0 is the pair's."""
    states = [0 if visited else 1 for visited in visits] + [1]
    pay = [10.0 if visited else 0.0 for visited in visits[:-1]] + [-2.0]
    return [(s, 0, r, s_next, 0, False) for s, r, s_next in zip(states, pay, states[1:], strict=False)]


def plot_lab(visits: Sequence[bool], alpha: float, lam: float) -> Picture:
    """Above the trace of the pair at each update, with a mark where α e > 1; below its value, beside the ideal."""
    steps, t = drive(visits), np.arange(1, len(visits) + 1)
    figure = Picture(figsize=(7.5, 5.6))
    above, below = figure.subplots(2, 1, sharex=True)
    ideal = [q[0, 0] for q in online_lambda_return(steps, np.zeros((2, 1)), alpha, GAMMA, lam)]
    below.plot(t, ideal, color=BLACK, linewidth=5, alpha=0.35, label="ideal")
    told = [f"ideal {ideal[-1]:.1f}"]
    for trace in TRACES:
        e = trace_over_time(trace, visits, alpha, lam)
        over = np.array(visits) & (alpha * e > 1 + 1e-9)
        above.plot(t, e, **LOOK[trace], markersize=5, label=trace)
        if over.any():
            above.plot(t[over], e[over], "X", color=VERMILION, markersize=11, label="α·e > 1: past its target")
        agents = replay(trace, steps, Size((2,), 1), alpha=alpha, gamma=GAMMA, lam=lam, traces="full")
        q = [float(agent.q[0, 0]) for agent in agents]
        below.plot(t, q, **LOOK[trace], markersize=5)
        told.append(f"{trace} {q[-1]:.1f}" + (f", overshooting in {over.sum()} steps" if over.any() else ""))
    above.axhline(1 / alpha, color=GREY, linestyle=(0, (1, 1)), label=f"limit, 1/α = {1 / alpha:.3g}")
    above.plot(t[np.array(visits)], np.full(sum(visits), -0.3), "|", color=GREY, markersize=9)
    above.set(ylabel="trace e at the update", title=f"α = {alpha:g}, λ = {lam:g}: traces above, Q of the pair below",
              ylim=(-0.6, 6))  # fmt: skip
    below.set(xlabel="second (the last one is the bump)", ylabel="Q of the pair", xticks=t)
    for ax in (above, below):
        ax.grid(alpha=0.3)
        ax.legend(loc="upper left", bbox_to_anchor=(1.01, 1), fontsize=8)
    figure.alt = f"A pair visited in {sum(visits)} of {len(visits)} seconds, α = {alpha:g}, λ = {lam:g}. "
    figure.alt += f"Its value after the bump: {'; '.join(told)}."
    return figure
