"""The CSS of the stepper. It stays on the page while the view changes."""

from __future__ import annotations

from rlrobot_edu.show.palette import BLUE, ORANGE, PURPLE, ROLE, VERMILION

# JupyterLab's own colours where there are any, so that the view follows its theme
_TEXT, _FAINT = "var(--jp-ui-font-color1, currentColor)", "var(--jp-ui-font-color2, currentColor)"
_LINE, _BACK = "var(--jp-border-color2, #9999)", "var(--jp-layout-color2, #8882)"

# widths are those of the view itself, whatever else stands beside it on the page
STYLE = f"""<style>
.rl-stepper {{ max-width: 1640px; color: {_TEXT}; overflow: hidden }}
.rl-stepper .widget-html {{ min-height: 0; margin: 1px 2px }}
.rl-stepper .widget-html-content {{ line-height: 1.3; font-size: 13px; color: {_TEXT}; width: 100% }}
.rl-view {{ container-type: inline-size; padding: 0 2px }}
.rl-view p {{ margin: 0 }}
.rl-view .said {{ min-height: 2.6em; font-size: 14px }}
.rl-view .said details {{ display: inline-block; border: 1px solid {_LINE}; border-radius: 9px; padding: 0 7px }}
.rl-view .said summary {{ display: inline; cursor: pointer }}
.rl-view .badge {{ border: 1px solid {_TEXT}; border-radius: 9px; padding: 0 7px; font-size: 12px;
  white-space: nowrap }}
.rl-view .panes {{ display: grid; grid-template-columns: 290px minmax(0, 1fr); gap: 0 16px; align-items: start }}
.rl-view .wide {{ grid-template-columns: 460px minmax(0, 1fr) }}
.rl-view .right {{ display: flex; flex-wrap: wrap; gap: 0 16px; align-items: flex-start }}
.rl-view section {{ min-width: 0; max-width: 100% }}
.rl-view .right .update {{ flex: 1 1 100% }}
@container (max-width: 960px) {{ .rl-view .wide {{ grid-template-columns: minmax(0, 1fr) }} }}
@container (max-width: 690px) {{ .rl-view .panes {{ grid-template-columns: minmax(0, 1fr) }}
  .rl-view .panes:not(.wide) .left {{ display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, 1fr);
    gap: 14px }} }}
@container (min-width: 1250px) {{ .rl-view .panes {{ grid-template-columns: 380px minmax(0, 1fr) }}
  .rl-view .wide {{ grid-template-columns: 560px minmax(0, 1fr) }}
  .rl-view .right:not(:has(.traces)) .update {{ flex: 1 1 0; min-width: 520px }}
  .rl-view .right > .note {{ flex: 1 1 100% }} }}
.rl-view h4 {{ font-size: 13px; font-weight: 600; margin: 6px 0 4px; padding: 0; border-bottom: 1px solid {_LINE} }}
.rl-view :is(.world, .update, .q) h4 {{ font-size: 15px }}
.rl-view .world h4::before {{ content: "1 · " }}
.rl-view .update h4::before {{ content: "2 · " }}
.rl-view .q h4::before {{ content: "3 · " }}
.rl-view :is(.choice, .traces) h4 {{ font-weight: 400; color: {_FAINT} }}
.rl-view .note {{ color: {_FAINT}; font-size: 12px; margin-top: 3px }}
.rl-view .q > .note, .rl-view .traces > .note {{ width: 0; min-width: 100% }}
.rl-view table {{ border-collapse: separate; border-spacing: 1px; margin: 0; font-size: 12px; border: 0 }}
.rl-view tr, .rl-view tr:nth-child(even), .rl-view tr:hover {{ background: none }}
.rl-view th, .rl-view td {{ padding: 0 3px; text-align: right; white-space: nowrap; height: 18px; line-height: 18px;
  font-variant-numeric: tabular-nums; box-sizing: border-box; color: {_TEXT}; border: 0; vertical-align: middle }}
.rl-view th {{ font-weight: 400; color: {_FAINT} }}
.rl-view th.on, .rl-view .on th, .rl-view .on td {{ font-weight: 700; color: {_TEXT} }}
.rl-view .blocks {{ display: flex; flex-wrap: wrap; gap: 4px 10px }}
.rl-view .q td, .rl-view .traces td {{ width: 51px; min-width: 51px; max-width: 51px; position: relative;
  font-size: 11px; box-shadow: inset 0 0 0 1px {_BACK} }}
.rl-view .q th, .rl-view .traces th {{ min-width: 40px; font-size: 11px }}
.rl-view tr.empty td {{ box-shadow: none }}
@container (max-width: 560px) {{ .rl-view .q td, .rl-view .traces td {{ width: 44px; min-width: 44px; max-width: 44px;
  padding: 0 2px; font-size: 10px }} .rl-view .q th, .rl-view .traces th {{ padding: 0 1px; min-width: 34px }} }}
.rl-view .q td.dot, .rl-view .traces td.dot {{ color: {_FAINT}; text-align: center }}
.rl-view .q td {{ height: 23px; line-height: 11px }}
.rl-view .q u {{ position: absolute; left: 2px; bottom: 1px; font-size: 9px; text-decoration: none }}
.rl-view .q small {{ display: block; font-size: 9px; line-height: 10px; font-weight: 400; margin: 0 -1px }}
.rl-view .q em, .rl-view .traces em {{ font-family: serif; font-size: 13px; line-height: 0 }}
.rl-view .q td.new {{ outline: 1px dashed color-mix(in srgb, {_TEXT} calc(100% * var(--strength, 1)), transparent);
  outline-offset: -1px; animation: rl-flash .7s ease-out }}
.rl-view td.pair {{ outline: 3px double {_TEXT} !important; outline-offset: -1px !important; font-weight: 700;
  z-index: 1 }}
@keyframes rl-flash {{ from {{ box-shadow: inset 0 0 0 30px {ORANGE} }} }}
@media (prefers-reduced-motion: reduce) {{ .rl-view .q td.new {{ animation: none }} }}
.rl-view:has(.to-pair:hover) .q td.pair, .rl-view:has(.to-next:hover) .q td.next,
.rl-view:has(.to-trace:hover) .traces td.pair, .rl-view:has(.to-reward:hover) .rewards b:last-child {{
  outline: 4px solid {ORANGE} !important; outline-offset: 0 !important; z-index: 2 }}
.rl-view .line span[class^=to-] {{ cursor: help }}
.rl-view .line span[class^=to-]:hover {{ background: {ORANGE}80 !important }}
.rl-view .scale b, .rl-view .rewards b {{ font-weight: 400; padding: 0 4px; margin-right: 2px; display: inline-block;
  color: {_TEXT}; box-shadow: inset 0 0 0 1px {_BACK} }}
.rl-view .rewards {{ font-size: 11px; min-height: 34px; margin-top: 4px; line-height: 17px }}
.rl-view .rewards b:last-child {{ font-weight: 700; outline: 1px solid {_TEXT} }}
.rl-view .rewards i {{ margin-right: 3px; font-style: normal }}
.rl-view .world svg {{ display: block; width: 100%; max-height: 400px; background: #fff; margin: 0 auto }}
.rl-view svg * {{ vector-effect: non-scaling-stroke }}
.rl-view .path {{ fill: none; stroke: {PURPLE}; stroke-width: 2 }}
.rl-view .beams {{ stroke: {ROLE["beam"]}; stroke-width: 1 }}
.rl-view .lines {{ stroke: {_FAINT}; stroke-width: 1; opacity: .5 }}
.rl-view .heading {{ stroke: #fff; stroke-width: 3; stroke-linecap: round }}
.rl-view .chip text {{ font-size: .09px; text-anchor: middle; fill: #000 }}
.rl-view svg.cells {{ background: none; fill: {_TEXT} }}
.rl-view .cells rect {{ stroke: {_FAINT}; stroke-width: 1 }}
.rl-view .cells circle {{ stroke-width: 3; pointer-events: none }}
.rl-view .cells .faint {{ fill: {_FAINT} }}
.rl-view .cells .path {{ opacity: .6 }}
.rl-view .cells .v {{ text-anchor: middle }}
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
.rl-view .line {{ display: flex; flex-wrap: wrap; align-items: end; margin-bottom: 4px; font-size: 14px }}
.rl-view .line nobr {{ display: flex }}
.rl-view .line span {{ text-align: center; padding: 0 1px }}
.rl-view .line .sign {{ padding: 0 5px }}
.rl-view .line i {{ display: block; font-family: serif; font-size: 15px; height: 19px; line-height: 19px }}
.rl-view .line b {{ font-weight: 400; font-variant-numeric: tabular-nums }}
.rl-view .line nobr span:last-child b {{ font-weight: 700 }}
.rl-view .update .note {{ min-height: 1.3em }}
.rl-view .code {{ overflow-x: auto }}
.rl-view summary {{ cursor: pointer }}
.rl-view .code div {{ font: 12px/16px var(--jp-code-font-family, monospace); white-space: pre-wrap }}
.rl-view .code .hot {{ background: {_BACK}; font-weight: 700 }}
.rl-view .code b {{ color: {VERMILION}; display: inline-block; width: 1.2em }}
.rl-view .code s {{ text-decoration: none; color: {_FAINT}; font-weight: 400 }}
.rl-keys {{ padding: 1px 8px; border: 1px solid {_LINE}; border-radius: 3px; cursor: pointer; font-size: 12px }}
.rl-keys:focus {{ outline: 3px solid {BLUE}; outline-offset: -2px }}
.rl-keys kbd {{ border: 1px solid {_LINE}; border-radius: 3px; padding: 0 4px; font: inherit }}
.rl-live {{ position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%) }}
.rl-stepper .rl-error {{ color: var(--jp-error-color0, {VERMILION}); font-weight: 600; margin: 2px 0 }}
.rl-stepper .rl-error[role=status] {{ color: {_TEXT} }}
</style>"""
