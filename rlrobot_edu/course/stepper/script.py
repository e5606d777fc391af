"""What the page does by itself: the keyboard, what is said aloud, and whether the kernel still answers."""

from __future__ import annotations

import html

from rlrobot_edu.course.page_script import when_there

SILENCE = 4  # seconds without an answer, then the page says so

# `rl` belongs to one view on one page. `asked` and `answered` are the times of a click and of the kernel's word that it
# has dealt with it. A held key asks for the next step only once the last one is answered, so nothing piles up. Keys
# count wherever the focus is, also on a button just clicked; lm-suppress keeps JupyterLab's own shortcuts away.
_INSTALL = """
const root = this.closest('.rl-stepper');
if (root && !root.rl) {
  const find = name => root.querySelector('.rl-' + name);
  const keys = {ArrowLeft: 'back', ArrowRight: 'step', ' ': 'play', Home: 'first', End: 'last'};
  const rl = root.rl = {asked: 0};
  rl.ask = () => {
    rl.asked = Date.now();
    clearTimeout(rl.silence);
    rl.silence = setTimeout(() => { find('silent').hidden = false; }, SILENCE);
  };
  rl.answered = () => {
    rl.asked = 0;
    clearTimeout(rl.silence);
    find('silent').hidden = true;
    for (const slider of root.querySelectorAll('.widget-slider')) {
      slider.querySelector('.noUi-handle')?.setAttribute('aria-label', slider.querySelector('label')?.textContent);
    }
  };
  rl.shown = () => {
    rl.answered();
    find('shown').click();
    clearTimeout(rl.speech);
    rl.speech = setTimeout(() => { find('live').textContent = root.querySelector('.said span').textContent; }, 500);
  };
  rl.key = event => {
    const name = keys[event.key], for_itself = event.key === ' ' ? 'button, summary' : 'input, .widget-slider';
    if (!name || event.ctrlKey || event.altKey || event.metaKey || event.target.closest(for_itself)) return;
    event.preventDefault();
    event.stopPropagation();
    if (!event.repeat || !rl.asked) find(name).click();
  };
  root.setAttribute('data-lm-suppress-shortcuts', 'true');
  root.addEventListener('keydown', rl.key);
  root.addEventListener('click', event => {
    const button = event.target.closest('button');
    if (button && !button.classList.contains('rl-shown')) rl.ask();
  }, true);
}
""".replace("SILENCE", str(1000 * SILENCE))

_RL = "this.closest('.rl-stepper')?.rl?."


KEYS = (
    '<div class="rl-keys" tabindex="0" role="group" '
    'aria-label="Keyboard of the stepper: left and right arrow step, space plays and pauses, Home and End go to the '
    'ends">Keyboard (click the view, or come here with Tab): <kbd>←</kbd> <kbd>→</kbd> step &nbsp; <kbd>Space</kbd> '
    "play or pause &nbsp; <kbd>Home</kbd> <kbd>End</kbd> first and last step</div>"
    '<p class="rl-live" aria-live="polite"></p><p class="rl-silent rl-error" role="alert" hidden>The kernel does not '
    "answer. It is busy with another cell, or it was restarted: then run this cell again.</p>"
    + when_there(" ".join(_INSTALL.split()))
)

_ON_CLICK = "this.closest('.rl-stepper')?.querySelector('.rl-keys').focus({preventScroll: true})"


def framed(view: str) -> str:
    """The view, ready for the page: a click on it brings the keyboard to it, and the kernel hears when it is shown."""
    return f'<div class="rl-view" onclick="{_ON_CLICK}">{view}{when_there(_RL + "shown()")}</div>'


def answer(text: str, kind: str, number: int) -> str:
    """What the kernel says to click `number`, often nothing: the page hears that there is a kernel."""
    said = f'<p class="rl-error" role="{kind}">{html.escape(text)}</p>' if text else ""
    return f"{said}<!-- {number} -->{when_there(_RL + 'answered()')}"
