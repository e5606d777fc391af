"""The tutorials: what they tell to type does what they say."""

import re
import subprocess
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]
HOWTO = ROOT / "docs/howto"


def changed(text: str, diff: str) -> str:
    """The text after one change: lines with - go, those with + take their place."""
    old, new = (
        "".join(line[1:] + "\n" for line in diff.splitlines() if line[0] != other)
        for other in ("+", "-")
    )
    assert old in text, f"there are no such lines:\n{old}"
    return text.replace(old, new)


def test_your_own_task_is_as_its_page_tells(tmp_path):
    page = (HOWTO / "your_own_task.md").read_text(encoding="utf-8")
    said, told = "", 0
    for kind, block in re.findall(r"```(\w+)\n(.*?)```", page, re.DOTALL):
        if kind == "diff":
            task = tmp_path / "hurry.py"
            task.write_text(
                changed(task.read_text(encoding="utf-8"), block), encoding="utf-8"
            )
        elif kind in ("sh", "python"):
            command = ["-c", block] if kind == "python" else block.split()[1:]
            done = subprocess.run(
                [sys.executable, *command],
                cwd=tmp_path,
                capture_output=True,
                text=True,
                encoding="utf-8",
            )
            assert done.returncode == 0, done.stderr
            said = done.stdout
        else:
            lines = [line for line in block.splitlines() if line]
            assert [line for line in lines if line not in said.splitlines()] == []
            told += len(lines)
    assert (
        told > 10
        and (tmp_path / "hurry.gif").stat().st_size
        > 10_000
        < (tmp_path / "hurry_3d.html").stat().st_size
    )


def test_your_own_algorithm_prints_what_its_page_says():
    page = (HOWTO / "your_own_algorithm.md").read_text(encoding="utf-8")
    (code,), (said,) = (
        re.findall(rf"```{kind}\n(.*?)```", page, re.DOTALL)
        for kind in ("python", "text")
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, encoding="utf-8"
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout == said


def test_the_architecture_page_shows_the_packages_and_layers_that_the_linter_checks():
    tools = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]
    packages, layers = tools["importlinter"]["contracts"][:2]
    page = (HOWTO / "architecture.md").read_text(encoding="utf-8")
    first, second = page.split("| layer | folder |")
    assert {name for line in packages["layers"] for name in line.split(" | ")} == set(
        re.findall(r"^\| `(\w+)`", first, re.MULTILINE)
    )
    expected = [
        sorted(re.split(" [|:] ", layer.replace("rlrobot_edu.", "")))
        for layer in layers["layers"]
    ]
    rows = re.findall(r"^\| \w* ?\| (`[^|]*) \|", second, re.MULTILINE)
    assert [sorted(re.findall("`(.*?)`", row)) for row in rows] == expected
