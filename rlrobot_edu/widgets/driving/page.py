"""What the page does by itself while a person drives: keys press buttons, one step after the other."""

from __future__ import annotations

from rlrobot_edu.jupyter import anywidget, traitlets
from rlrobot_edu.show.room.tokens import look

# `busy` is on from a press until the kernel has answered, so a held key asks for one step at a time. Keys count
# wherever the focus is in the pad, also on a button just clicked; lm-suppress keeps JupyterLab's own shortcuts away,
# in which 1 makes a heading of the cell and x cuts it out.
_KEYS = """
export default {
  render({ model, el }) {
    const keys = model.get("actions"), line = document.createElement("div");
    let busy = false;
    line.className = "rl-keys";
    line.tabIndex = 0;
    line.setAttribute("role", "group");
    line.textContent = `Keys (click here, or come with Tab): ${model.get("told")}`;
    el.append(line);
    const press = (root, event) => {
      const action = keys[event.key];
      if (action === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
      event.preventDefault();
      event.stopPropagation();
      if (event.repeat && busy) return;
      busy = true;
      root.querySelector(`.rl-action-${action}`).click();
    };
    const listen = () => {
      const root = el.closest(".rl-drive"), buttons = root?.querySelectorAll("button[title]") ?? [];
      if (!buttons.length) return setTimeout(listen, 50); // it is not on the page yet
      root.setAttribute("data-lm-suppress-shortcuts", "true");
      root.onkeydown = (event) => press(root, event);
      for (const button of buttons) button.setAttribute("aria-label", `${button.textContent.trim()}: ${button.title}`);
    };
    listen();
    model.on("change:answered", () => { busy = false; });
  },
};
"""
_STYLE = """
.rl-drive { padding: 10px; border-radius: var(--round) }
.rl-drive.rl-look button { min-width: 4.6em; min-height: 44px; padding: 0 10px }
.rl-drive :is(button:focus-visible, .rl-keys:focus) { outline: 3px solid var(--focus) !important; outline-offset: -3px }
"""


class Keyboard(anywidget.AnyWidget):
    """A line that takes the keys of the widget around it, which has the class ``rl-drive``.

    actions: the action of each key; the button of action 7 has the class ``rl-action-7``; told: the keys in words
    answered: number of the last step that the kernel has taken; after that the next one may come
    """

    _esm, _css = _KEYS, look() + _STYLE
    actions = traitlets.Dict().tag(sync=True)
    told = traitlets.Unicode().tag(sync=True)
    answered = traitlets.Int().tag(sync=True)
