"""The page of a stepper without a browser: node runs its program."""

import json
import shutil
import subprocess

import pytest

import rlrobot_edu as rl
from rlrobot_edu.widgets.stepper.told import feed


def on_its_page(stepper: rl.Stepper, program: str):
    """What a JavaScript expression gives in which ``stepper`` is the page's, and ``views`` tells its panes' HTML."""
    if shutil.which("node") is None:
        pytest.skip("node is missing: it runs JavaScript")
    told = json.dumps(feed(stepper._tape, stepper._names, stepper._hide, stepper.t))
    text = (
        f"{stepper._script()}\nconst stepper = new Stepper({told}, lives, null);\n"
        "const views = (tape) => viewHtml(stepper.about, tape);\n"
        f"console.log(JSON.stringify({program}));"
    )
    done = subprocess.run(["node", "-"], input=text, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads(done.stdout)


def view(stepper: rl.Stepper) -> str:
    """The panes of the page at the step shown."""
    return on_its_page(stepper, "views(stepper.tape)")
