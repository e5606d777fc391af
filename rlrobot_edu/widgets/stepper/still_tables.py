"""Q and the traces in the still picture."""

from __future__ import annotations

from collections.abc import Callable

from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_edu.show.picture import plain
from rlrobot_edu.widgets.stepper.colours import largest, tint, trace_tint
from rlrobot_edu.widgets.stepper.names import Names
from rlrobot_edu.widgets.stepper.numerals import short
from rlrobot_edu.widgets.stepper.tables import Window, traces_of
from rlrobot_edu.widgets.stepper.tape import Tape

COLUMNS = 10  # so many fit side by side, with their numbers in a type of SIZE points
SIZE, SMALL = 8.5, 7.5
GAP = 1.3  # cells between two blocks

Look = tuple[str, str, float]  # of a cell: text, colour, opacity


def n_rows(window: Window) -> int:
    """Rows of a table: states that do not fit below each other stand side by side, as far as there is room."""
    states = sum(s is not None for s in window.states)
    blocks = max(
        1, min(int((COLUMNS + GAP) // (len(window.actions) + GAP)), -(-states // 8))
    )
    return -(-states // blocks)


def draw_q(ax: Axes, tape: Tape, window: Window, names: Names) -> None:
    """Q with a dot where nothing was tried; what the step changed is framed and carries ▲ or ▼."""
    most, frame, n_actions = (
        largest(tape.q, tape.agent.parameters.r_max),
        tape.frame,
        tape.q.shape[1],
    )

    def look(s: int, a: int) -> Look:
        value = float(tape.q[s, a])
        return (
            "·" if not value and not tape.visits[s, a] else short(value),
            *tint(value, most),
        )

    places = _draw(ax, tape, window, names, look)
    ax.set_title(
        f"Q: {window.says}; · never tried; framed: changed by this step, bold: (s, a)",
        fontsize=9.5,
    )
    if frame is None:
        return
    for where, old, new in zip(
        *(column.tolist() for column in frame.q_change), strict=True
    ):
        pair = divmod(where, n_actions)
        if (place := places.get(pair)) is not None:
            bold = pair == (frame.step.s, frame.step.a)
            ax.add_patch(Rectangle(place, 1, 1, fill=False, edgecolor="black", linewidth=2.2 if bold else 1.1,
                                   linestyle="-" if bold else "--", zorder=3))  # fmt: skip
            ax.text(
                place[0] + 0.05,
                place[1] + 0.5,
                "▲" if new > old else "▼",
                va="center",
                fontsize=SMALL - 2,
            )


def draw_traces(ax: Axes, tape: Tape, window: Window, names: Names) -> None:
    """The traces by which the update learned."""
    traces, n_actions = traces_of(tape.frame), tape.q.shape[1]

    def look(s: int, a: int) -> Look:
        e = traces.get(s * n_actions + a, 0.0)
        return short(e) if e else "·", *trace_tint(e)

    _draw(ax, tape, window, names, look)
    ax.set_title("Traces e, as this update used them", fontsize=9.5)


def _draw(
    ax: Axes, tape: Tape, window: Window, names: Names, look: Callable[[int, int], Look]
) -> dict[tuple[int, int], tuple[float, float]]:
    """Cells with what `look(s, a)` says, block beside block. Returns the corner of each pair (s, a)."""
    states, n, rows = (
        [s for s in window.states if s is not None],
        len(window.actions),
        n_rows(window),
    )
    places, step = {}, tape.frame.step if tape.frame else None
    for i, s in enumerate(states):
        x, y = i // rows * (n + GAP), i % rows
        role = "s " * (step is not None and s == step.s) + "s′ " * (
            step is not None and s == step.s_next
        )
        ax.text(x - 0.1, y + 0.5, f"{role}{s}", ha="right", va="center", fontsize=SIZE)
        for j, a in enumerate(window.actions):
            text, colour, opacity = look(s, a)
            places[s, a] = x + j, y
            ax.add_patch(
                Rectangle(
                    (x + j, y), 1, 1, facecolor=colour, alpha=opacity, linewidth=0
                )
            )
            ax.add_patch(
                Rectangle((x + j, y), 1, 1, fill=False, edgecolor="#ccc", linewidth=0.5)
            )
            place, side = (0.5, "center") if text == "·" else (0.94, "right")
            ax.text(
                x + j + place,
                y + 0.5,
                text,
                ha=side,
                va="center",
                fontsize=SIZE if n <= 4 else SMALL,
            )
    blocks = -(-len(states) // rows)
    for block in range(blocks):
        for j, a in enumerate(window.actions):
            ax.text(
                block * (n + GAP) + j + 0.5,
                -0.1,
                plain(names.column(a)),
                ha="center",
                va="bottom",
                fontsize=SIZE,
            )
    ax.set(xlim=(-GAP, blocks * (n + GAP) - GAP + 0.1), ylim=(rows + 0.05, -1))
    ax.set_axis_off()
    return places
