"""All states of a small task as buttons, in blocks that show what the states have in common."""

from __future__ import annotations

from collections.abc import Callable
from html import escape

import ipywidgets

from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.bias_explorer.bias import BiasNumbers
from rlrobot_edu.widgets.bias_explorer.marks import HERE, Mark, here
from rlrobot_edu.widgets.bias_explorer.states import block_text, blocks_of, place_of, state_words, value_text

FRAME = {"border": "1px solid #7f7f7f", "margin": "2px", "padding": "0 4px 4px"}
CELL = {"width": "auto", "margin": "1px", "padding": "0"}


class StateButtons:
    """One button a state; the states that have a say carry the colour and the mark of their input.

    marks: of each input, by name; choose: called with the number of a state that was clicked
    """

    def __init__(self, task: Task, marks: dict[str, Mark], choose: Callable[[int], None]) -> None:
        self._task, self._marks = task, marks
        self.buttons = []
        for s in range(task.states.n):
            tooltip = f"state {s}: {state_words(task, s)}"
            button = ipywidgets.Button(description=str(s), tooltip=tooltip, layout=CELL, style={"font_size": "11px"})
            button.on_click(lambda _, s=s: choose(s))
            self.buttons.append(button)
        blocks = blocks_of(task)
        across, up = (max(block[i] for block in blocks) + 1 for i in (0, 1))
        rows = [[self._block(blocks[column, row]) for column in range(across)] for row in reversed(range(up))]
        self.widget = ipywidgets.VBox([ipywidgets.HBox(row) for row in rows])

    def update(self, numbers: BiasNumbers) -> None:
        """Mark the state that `numbers` is about, and the members of its sets."""
        looks = [(str(s), None, None) for s in range(len(self.buttons))]
        for s, name in numbers.members:
            mark = HERE if name is None else self._marks[name]
            looks[s] = (here(s) if name is None else f"{s} {mark.sign}", mark.colour, mark.ink)
        for button, (label, colour, ink) in zip(self.buttons, looks, strict=True):
            button.description = label
            with button.style.hold_sync():  # one message to the browser instead of two
                button.style.button_color, button.style.text_color = colour, ink

    def _block(self, states: list[int]) -> ipywidgets.Widget:
        """A frame with its title: a column for each value of the last input but one, a row for each of the last."""
        *_, last = inputs = self._task.inputs
        tops = [""]
        if len(inputs) > 1:
            tops = [value_text(inputs[-2].decode(i)) for i in range(inputs[-2].n_bins)]
            tops[0] = f"{inputs[-2].name} {tops[0]}"  # said once: blocks are to be narrow
        cells = [_label(""), *(_label(top, "center") for top in tops)]
        for row in range(last.n_bins):
            cells.append(_label(f"{last.name} {value_text(last.decode(row))}", "right"))
            cells.extend(self.buttons[s] for s in states if place_of(self._task, s).row == row)
        # [pixels] room for a number and its sign, and for the longest heading
        width = max(44, 6 * max(map(len, tops)))
        columns = f"auto repeat({len(tops)}, {width}px)"
        grid = ipywidgets.GridBox(cells, layout={"grid_template_columns": columns, "grid_gap": "0 2px"})
        title = _label(block_text(self._task, states[0]), weight="bold")
        return ipywidgets.VBox([title, grid], layout=FRAME)


def _label(text: str, align: str = "left", weight: str = "normal") -> ipywidgets.HTML:
    style = f"text-align:{align};font-weight:{weight};line-height:24px;font-size:11px;white-space:nowrap"
    return ipywidgets.HTML(f'<div style="{style}">{escape(text)}</div>')
