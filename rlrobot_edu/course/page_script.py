"""Small programs that a page runs by itself as soon as it contains a widget's HTML."""

from __future__ import annotations

import html

# A picture of one invisible dot: what stands in its onload runs once it is on the page.
_DOT = "data:image/gif;base64,R0lGODlhAQABAIAAAAAAAP///yH5BAEAAAAALAAAAAABAAEAAAIBRAA7"


def when_there(script: str) -> str:
    """HTML that runs `script` as soon as it is on the page; `this` is an invisible picture at its place."""
    return f'<img alt="" style="position:absolute" src="{_DOT}" onload="{html.escape(script)}">'


# ipywidgets writes a slider's name beside it, but gives the handle itself none, which a screen reader would tell
NAMED_HANDLES = when_there("""
const box = this.closest('.widget-vbox');
setTimeout(() => {
  for (const slider of box?.querySelectorAll('.widget-slider') ?? []) {
    slider.querySelector('.noUi-handle')?.setAttribute('aria-label', slider.querySelector('label')?.textContent);
  }
}, 100);
""")
