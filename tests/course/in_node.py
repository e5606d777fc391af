"""Pages without a browser: node runs their programs."""

import json
import shutil
import subprocess

import pytest

import rlrobot_edu as rl
from rlrobot_edu.widgets.bias_explorer.explorer import BiasExplorer
from rlrobot_edu.widgets.bias_explorer.widget import script
from rlrobot_edu.widgets.stepper.page_data import feed


def run(text: str):
    """What node writes, as JSON."""
    if shutil.which("node") is None:
        pytest.skip("node is missing: it runs JavaScript")
    done = subprocess.run(["node", "-"], input=text, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads(done.stdout)


def on_its_page(stepper: rl.Stepper, program: str):
    """What a JavaScript expression gives in which ``stepper`` is the page's, and ``views`` tells its panes' HTML."""
    told = json.dumps(feed(stepper._tape, stepper._names, stepper.t))
    return run(
        f"{stepper._script()}\nconst stepper = new Stepper({told}, replayData, null);\n"
        "const views = (tape) => viewHtml(stepper.about, tape);\n"
        f"console.log(JSON.stringify({program}));"
    )


def view(stepper: rl.Stepper) -> str:
    """The panes of the page at the step shown."""
    return on_its_page(stepper, "views(stepper.tape)")


def explored(explorer: BiasExplorer) -> list[dict]:
    """Of each state what the explorer's page computes of the table shown.

    ``said`` tells what it says, by action and stage; ``finding`` its title; ``html`` all that it writes at some time.
    """
    widget = explorer.widget
    told = json.dumps([widget.about, widget.tables[widget.table], widget.table])
    return run(
        f"{script()}\nconst [about, q, table] = {told}, {{ scale }} = about.originals[table];\n"
        "console.log(JSON.stringify(q.map((_, s) => {\n"
        "  const found = biasOf(about, q, scale, s), stages = [0, 1, 2, 3, 4];\n"
        "  const said = about.actions.map((_, a) => stages.map((stage) => saidHtml(about, q, s, a, stage, found)));\n"
        "  for (const name of ['bias', 'sr', 'qbiassr']) found[name] = [...found[name]];\n"
        "  found.means = found.means.map((mean) => [...mean]);\n"
        "  const keys = [legendHtml(about, s, 4), barsHtml(about, scale)];\n"
        "  const html = [explorerHtml(about), ...said.flat(), ...keys].join('');\n"
        "  return { ...found, said, html, finding: findingHtml(about, q, s, found) };\n"
        "})));"
    )
