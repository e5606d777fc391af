"""What the page does by itself while a person drives: keys press buttons, one step after the other."""

from __future__ import annotations

import html
import json
from collections.abc import Mapping

from rlrobot_edu.course.page_script import when_there

# `busy` is on from a press until the kernel has answered, so a held key asks for one step at a time.
_INSTALL = """
const root = this.closest('.rl-drive'), keys = KEYS;
root.rlKey = event => {
  const action = keys[event.key];
  if (action === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  event.stopPropagation();
  if (!event.repeat || !root.rlBusy) {
    root.rlBusy = true;
    root.querySelector('.rl-action-' + action).click();
  }
};
"""

STYLE = """<style>
.rl-drive button { min-width: 4.5em; min-height: 2.4em; font-size: 110%; }
.rl-drive .rl-keys:focus { outline: 3px solid #0072b2; outline-offset: 2px; }
</style>"""


def keyboard(keys: Mapping[str, int], told: str) -> str:
    """A line that takes the keys; keys: action of each; told: which they are, in words."""
    words = html.escape(f"Keyboard (click here, or come with Tab): {told}")
    install = " ".join(_INSTALL.replace("KEYS", json.dumps(dict(keys))).split())
    return (  # lm-suppress keeps JupyterLab's own shortcuts away
        f'{STYLE}<div class="rl-keys" tabindex="0" role="group" data-lm-suppress-shortcuts="true" '
        f"onkeydown=\"this.closest('.rl-drive').rlKey?.(event)\">{words}</div>{when_there(install)}"
    )


def answer(text: str, number: int) -> str:
    """What happened in step `number`, said aloud as well; the page may press the next button."""
    done = when_there("this.closest('.rl-drive').rlBusy = false")
    return f'<p aria-live="polite">{html.escape(text)}</p><!-- {number} -->{done}'
