"""What the page does by itself while a person drives: keys press buttons, one step after the other."""

from __future__ import annotations

import html
import json
from collections.abc import Mapping

from rlrobot_edu.course.page_script import when_there

# `rlBusy` is on from a press until the kernel has answered, so a held key asks for one step at a time. Keys count
# wherever the focus is in the pad, also on a button just clicked; lm-suppress keeps JupyterLab's own shortcuts away,
# in which 1 makes a heading of the cell and x cuts it out.
_INSTALL = """
const root = this.closest('.rl-drive'), keys = KEYS;
root.setAttribute('data-lm-suppress-shortcuts', 'true');
root.onkeydown = event => {
  const action = keys[event.key];
  if (action === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  event.stopPropagation();
  if (!event.repeat || !root.rlBusy) {
    root.rlBusy = true;
    root.querySelector('.rl-action-' + action).click();
  }
};
setTimeout(() => root.querySelectorAll('button[title]').forEach(
  button => button.setAttribute('aria-label', button.textContent.trim() + ': ' + button.title)), 100);
"""

STYLE = """<style>
.rl-drive button { min-width: 3.6em; min-height: 2.4em; padding: 0 6px; }
.rl-drive :is(button:focus-visible, .rl-keys:focus) { outline: 3px solid #0072b2 !important; outline-offset: -3px; }
.rl-drive .rl-keys { padding: 4px 8px; border: 1px dashed #7f7f7f; line-height: 1.4; }
</style>"""


def keyboard(keys: Mapping[str, int], told: str) -> str:
    """A line that takes the keys; keys: action of each; told: which they are, in words."""
    words = html.escape(f"Keys (click here, or come with Tab): {told}")
    install = " ".join(_INSTALL.replace("KEYS", json.dumps(dict(keys))).split())
    return f'{STYLE}<div class="rl-keys" tabindex="0" role="group">{words}</div>{when_there(install)}'


def answer(text: str, number: int) -> str:
    """What happened in step `number`, said aloud as well; the page may press the next button."""
    done = when_there("this.closest('.rl-drive').rlBusy = false")
    return f'<p aria-live="polite">{html.escape(text)}</p><!-- {number} -->{done}'
