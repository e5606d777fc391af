"""Handles: their numbers are Python's, their pictures fit on a phone, and their pages work by mouse and by keyboard."""

import json
import re

import numpy as np
import pytest
from in_node import run

import rlrobot_edu as rl
from rlrobot_course.handles.handle import Handle
from rlrobot_course.lesson_02.exercises import discounted_return
from rlrobot_course.lesson_02.handles import gamma_over
from rlrobot_course.lesson_07.handles import traces_on_a_path
from rlrobot_course.lesson_08.handles import traces_and_ideal, with_and_without_q_old

PHONE, SCREEN = 334, 820  # widths of a picture [px]
LETTER = 7.4  # width of a letter, on the average [px]


def rewards_of(policy, steps=200):
    env, rewards = rl.make_env("wander_simple", seed=0), []
    env.reset()
    for _ in range(steps):
        rewards.append(env.step(policy[env.state])[1])
    return rewards


def gamma() -> Handle:
    policies = {"turns away": [2, 2, 1, 3], "always forward": [3, 3, 3, 3]}
    return gamma_over({name: rewards_of(p) for name, p in policies.items()})


HANDLES = {
    "02 gamma": gamma,
    "07 traces": traces_on_a_path,
    "08 ideal": traces_and_ideal,
    "08 q_old": with_and_without_q_old,
}


@pytest.fixture(params=HANDLES)
def handle(request):
    return HANDLES[request.param]()


def asked(handle: Handle, *changes: dict, width: int = SCREEN) -> list[dict]:
    """What its program computes and draws as it opens, and after each of these changes of its values."""
    return run(
        f"const document = {{}};\n{handle.script}\n"
        f"const feed = {json.dumps(handle.feed)}, width = {width};\n"
        "const values = { ...handle.begins?.(feed) };\n"
        "for (const { name, value } of handle.controls(feed)) if (value !== undefined) values[name] = value;\n"
        f"console.log(JSON.stringify([{{}}, ...{json.dumps(changes)}].map((change) => {{\n"
        "  Object.assign(values, change);\n"
        "  const found = handle.compute(feed, values);\n"
        "  return { found, controls: handle.controls(feed), ...handle.draw(found, width, feed, values) };\n"
        "})));"
    )


def corners(handle: Handle) -> list[dict]:
    """Changes that take each control to its ends."""
    changes = []
    for control in asked(handle)[0]["controls"]:
        ends = {
            "slider": [control.get("min"), control.get("max")],
            "scrubber": [0, control.get("last")],
            "toggle": [True, False],
            "choice": list(range(len(control.get("options", [])))),
        }
        name = control["name"]
        begun = control.get("value")
        changes += [{name: end} for end in ends.get(control["kind"], [])]
        if begun is not None:
            changes.append({name: begun})
    return changes


@pytest.mark.parametrize("width", [PHONE, SCREEN])
def test_a_picture_fits_wherever_its_controls_stand(handle, width):
    for told in asked(handle, *corners(handle), width=width):
        assert told["finding"] and told["said"]
        assert "NaN" not in told["picture"] and "undefined" not in told["picture"]
        assert "NaN" not in told["finding"] + told["said"]
        found = re.findall(
            r'<text x="([-\d.]+)" y="([-\d.]+)" text-anchor="(\w+)"[^>]*>([^<]*)<',
            told["picture"],
        )
        assert found
        for x, y, anchor, text in found:
            size = LETTER * len(text)
            left = float(x) - {"start": 0, "middle": size / 2, "end": size}[anchor]
            assert left > -4 and left + size < width + 8, (text, x, width)
            assert 0 < float(y) <= told["height"], text


def test_a_handle_has_a_name_a_still_and_a_page_of_its_own(handle, tmp_path):
    assert repr(handle) == f"<Handle: {handle.name}>"
    assert handle.still().alt
    assert len(handle.still().data) < 80_000
    handle.save(tmp_path / "handle.html")
    assert (tmp_path / "handle.html").stat().st_size < 100_000


def test_what_gamma_leaves_adds_up_to_the_return():
    shown = gamma()
    for change in ({"gamma": 0.5}, {"gamma": 0.99}, {"gamma": 0.0}):
        found = asked(shown, change)[1]["found"]
        right = [discounted_return(r, change["gamma"]) for r in shown.feed["rewards"]]
        np.testing.assert_allclose(found["returns"], right, rtol=1e-12)
    assert "differ by 0.0" in asked(shown, {"gamma": 0.5})[1]["finding"]
