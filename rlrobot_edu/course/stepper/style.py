"""How the stepper looks, and its keyboard; both stay on the page while the view changes."""

from __future__ import annotations

from rlrobot_edu.show.palette import BLUE, PURPLE, ROLE, VERMILION

# JupyterLab's own colours where there are any, so that the view follows its theme
_TEXT, _FAINT = "var(--jp-ui-font-color1, currentColor)", "var(--jp-ui-font-color2, currentColor)"
_LINE, _BACK = "var(--jp-border-color2, #9999)", "var(--jp-layout-color2, #8882)"

STYLE = f"""<style>
.rl-stepper {{ max-width: 1000px; color: {_TEXT} }}
.rl-stepper .widget-html-content {{ line-height: 1.3; font-size: 13px; color: {_TEXT}; width: 100% }}
.rl-view {{ contain: content }}
.rl-view p {{ margin: 0 }}
.rl-view .said {{ min-height: 2.7em; font-size: 14px }}
.rl-view .badge {{ border: 1px solid {_TEXT}; border-radius: 9px; padding: 0 7px; font-size: 12px;
  white-space: nowrap }}
.rl-view .top {{ display: grid; grid-template-columns: 290px minmax(0, 1fr); gap: 14px }}
.rl-view .tables {{ display: flex; flex-wrap: wrap; gap: 14px; align-items: flex-start }}
.rl-view .q, .rl-view .traces {{ flex: 1 1 450px; min-width: 0 }}
.rl-view h4 {{ font-size: 13px; font-weight: 600; margin: 8px 0 4px; padding: 0; border-bottom: 1px solid {_LINE} }}
.rl-view .note {{ color: {_FAINT}; font-size: 12px; margin-top: 3px }}
.rl-view table {{ border-collapse: separate; border-spacing: 1px; margin: 0; font-size: 12px; border: 0 }}
.rl-view tr, .rl-view tr:nth-child(even), .rl-view tr:hover {{ background: none }}
.rl-view th, .rl-view td {{ padding: 0 3px; text-align: right; white-space: nowrap; height: 18px; line-height: 18px;
  font-variant-numeric: tabular-nums; box-sizing: border-box; color: {_TEXT}; border: 0; vertical-align: middle }}
.rl-view th {{ font-weight: 400; color: {_FAINT} }}
.rl-view th.on, .rl-view .on th, .rl-view .on td {{ font-weight: 700; color: {_TEXT} }}
.rl-view .blocks {{ display: flex; flex-wrap: wrap; gap: 10px }}
.rl-view .q td, .rl-view .traces td {{ width: 42px; min-width: 42px; max-width: 42px; position: relative;
  font-size: 11px }}
.rl-view .q th, .rl-view .traces th {{ min-width: 36px; font-size: 11px }}
.rl-view .q u {{ position: absolute; left: 1px; top: -1px; font-size: 8px; text-decoration: none }}
.rl-view .q em, .rl-view .traces em {{ font-family: serif; font-size: 13px; line-height: 0 }}
.rl-view .q td.new {{ outline: 2px dashed {VERMILION}; outline-offset: -2px }}
.rl-view .q td.pair {{ outline: 4px double {VERMILION}; outline-offset: -2px; font-weight: 700; z-index: 1 }}
.rl-view .traces td {{ box-shadow: inset 0 0 0 1px {_BACK} }}
.rl-view .world svg {{ display: block; width: 290px; max-height: 290px; background: #fff }}
.rl-view svg * {{ vector-effect: non-scaling-stroke }}
.rl-view .path {{ fill: none; stroke: {PURPLE}; stroke-width: 2 }}
.rl-view .beams {{ stroke: {ROLE["beam"]}; stroke-width: 1 }}
.rl-view .heading {{ stroke: #fff; stroke-width: 3; stroke-linecap: round }}
.rl-view .cells rect {{ stroke: #000; stroke-width: 1 }}
.rl-view .cells text {{ font-size: 0.3px; fill: #000 }}
.rl-view .big {{ font-size: 18px }}
.rl-view .bins i {{ display: inline-block; width: 15px; height: 15px; margin-right: 1px; border: 1px solid {_TEXT};
  box-sizing: border-box; vertical-align: middle }}
.rl-view .bins i.now {{ background: {BLUE} }}
.rl-view .bins i.was {{ border: 3px double {BLUE} }}
.rl-view .bins th, .rl-view .bins td {{ text-align: left; padding-right: 8px }}
.rl-view .choice table {{ width: 100% }}
.rl-view .choice th {{ min-width: 56px }}
.rl-view td.bar {{ width: 100%; padding: 0; box-shadow: inset 0 0 0 1px {_BACK} }}
.rl-view .bar b {{ display: block; height: 14px; background: {BLUE} }}
.rl-view .on .bar b {{ background: repeating-linear-gradient(135deg, {BLUE} 0 5px, {VERMILION} 5px 8px) }}
.rl-view .update table {{ font-size: 14px; margin-bottom: 4px }}
.rl-view .update {{ overflow-x: auto }}
.rl-view .update td {{ text-align: center; padding: 0 1px; height: 19px }}
.rl-view .update td.sign {{ padding: 0 5px }}
.rl-view .update tr:first-child td {{ font-family: serif; font-style: italic; font-size: 15px }}
.rl-view .update tr:last-child td:last-child {{ font-weight: 700 }}
.rl-view .update .note {{ min-height: 2.6em }}
.rl-view .code div {{ font: 12px/16px var(--jp-code-font-family, monospace); white-space: pre; overflow: hidden }}
.rl-view .code .hot {{ background: {_BACK}; font-weight: 700 }}
.rl-view .code b {{ color: {VERMILION}; display: inline-block; width: 1.2em }}
.rl-view .code s {{ text-decoration: none; color: {_FAINT}; font-weight: 400 }}
.rl-keys {{ padding: 2px 8px; border: 1px solid {_LINE}; border-radius: 3px; cursor: pointer }}
.rl-keys:focus {{ outline: 3px solid {BLUE}; outline-offset: 1px }}
.rl-keys kbd {{ border: 1px solid {_LINE}; border-radius: 3px; padding: 0 4px; font: inherit }}
.rl-error {{ color: var(--jp-error-color0, {VERMILION}); font-weight: 600 }}
</style>"""

# It presses the buttons, which are found by their classes; lm-suppress keeps JupyterLab's own shortcuts away.
_ON_KEY = (
    "const k = {ArrowLeft: 'back', ArrowRight: 'step', ' ': 'play', Home: 'first', End: 'last'}[event.key]; "
    "if (k &amp;&amp; !event.ctrlKey &amp;&amp; !event.altKey &amp;&amp; !event.metaKey) { event.preventDefault(); "
    "event.stopPropagation(); this.closest('.rl-stepper').querySelector('.rl-' + k).click(); }"
)

KEYS = (
    f'<div class="rl-keys" tabindex="0" role="group" data-lm-suppress-shortcuts="true" onkeydown="{_ON_KEY}" '
    'aria-label="Keyboard of the stepper: left and right arrow step, space plays and pauses, Home and End go to the '
    'ends">Keyboard (click the view, or come here with Tab): <kbd>←</kbd> <kbd>→</kbd> step &nbsp; <kbd>Space</kbd> '
    "play or pause &nbsp; <kbd>Home</kbd> <kbd>End</kbd> first and last step</div>"
)

# A click on the view brings the keyboard to it. The picture at its end, an invisible dot, tells the kernel that the
# page has shown the step: it loads once the view is there.
_ON_CLICK = "this.closest('.rl-stepper')?.querySelector('.rl-keys').focus({preventScroll: true})"
_ON_SHOWN = "this.closest('.rl-stepper')?.querySelector('.rl-shown').click()"
_DOT = "data:image/gif;base64,R0lGODlhAQABAIAAAAAAAP///yH5BAEAAAAALAAAAAABAAEAAAIBRAA7"


def framed(view: str) -> str:
    """The view, ready for the page."""
    dot = f'<img alt="" style="position:absolute" src="{_DOT}" onload="{_ON_SHOWN}">'
    return f'<div class="rl-view" onclick="{_ON_CLICK}">{view}{dot}</div>'
