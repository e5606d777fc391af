"""The stepper where a kernel runs: the page's own program, which asks the kernel for steps not yet taken."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import anywidget
import traitlets

from rlrobot_edu.widgets.stepper.saved_page import style

# One set of steps for all views of a widget, whichever cells show it; a view that comes later asks for what is new.
_SHOW = """
const kept = { frames: [], at: 0 };
function keep({ frames = [] }) {
  kept.frames.push(...frames.filter(({ t }) => t > (kept.frames.at(-1)?.t ?? -1)));
}
export default {
  initialize({ model }) {
    const { frames, at } = model.get("feed");
    Object.assign(kept, { frames: [...frames], at });
    model.on("msg:custom", keep);
  },
  render({ model, el }) {
    const stepper = new Stepper({ ...model.get("feed"), ...kept }, lives, (question) => model.send(question));
    const hear = (news) => stepper.hear(news);
    stepper.mount(el);
    model.on("msg:custom", hear);
    model.send({ have: stepper.recorded.end });
    return () => {
      stepper.stop();
      kept.at = stepper.recorded.t;
      model.off("msg:custom", hear);
    };
  },
};
"""


class StepperWidget(anywidget.AnyWidget):
    """A view of a stepper.

    script: the page's program; feed: its first data; hear: called with each question of the page
    """

    feed = traitlets.Dict().tag(sync=True)

    def __init__(
        self, script: str, feed: dict[str, Any], hear: Callable[[dict[str, Any]], None]
    ) -> None:
        self._esm, self._css = script + _SHOW, style()
        super().__init__(feed=feed)
        self.on_msg(lambda _, question, buffers: hear(question))
