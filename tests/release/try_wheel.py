"""What `make release` does once dist/ is filled: versions must agree, and each Python that is found tries the wheel.

Each has an environment of its own, build/python3.11, and runs the README's ten lines there with an empty home. The end
is what docs/howto/release.md leaves to a person.
"""

import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]


def disagreements(root: Path) -> list[str]:
    """What version.py, CITATION.cff and CHANGELOG.md say differently. Before the release none has a date."""
    files = [
        (root / name).read_text(encoding="utf-8")
        for name in ("CITATION.cff", "CHANGELOG.md")
    ]
    versions = [
        found(x, text)
        for x, text in zip((r"^version: (.+)", r"^## \[(.+)\]"), files, strict=True)
    ]
    versions.append(
        found(
            r'__version__ = "(.+)"',
            (root / "rlrobot_edu/version.py").read_text(encoding="utf-8"),
        )
    )
    dates = [
        found(x, text)
        for x, text in zip(
            (r"^date-released: (.+)", r"^## .+\] - (\d.+)"), files, strict=True
        )
    ]
    return [
        f"CITATION.cff, CHANGELOG.md and version.py differ: {x}"
        for x in (versions, dates)
        if len(set(x)) > 1
    ]


def found(pattern: str, text: str) -> str:
    """What the group of a pattern matches first; nothing where there is no match."""
    match = re.search(pattern, text, re.MULTILINE)
    return match[1] if match else ""


def is_there(python: str) -> bool:
    """Whether this Python is found and can make an environment; pyenv leaves names that lead nowhere."""
    path = shutil.which(python)
    return (
        path is not None
        and not subprocess.run(
            [path, "-c", "import ensurepip"], capture_output=True
        ).returncode
    )


def install(python: str, wheel: Path, folder: Path) -> None:
    """Make a new environment with the wheel, in the tested versions of what it needs."""
    shutil.rmtree(folder, ignore_errors=True)
    subprocess.run([python, "-m", "venv", folder / "venv"], check=True)
    pip = [
        folder / "venv/bin/python",
        "-m",
        "pip",
        "install",
        "--quiet",
        "--disable-pip-version-check",
    ]
    subprocess.run(
        [*pip, "--no-compile", "-c", ROOT / "constraints.txt", wheel], check=True
    )  # little of it is run


def run_alone(folder: Path, *command: str, **settings: str) -> str:
    """What a command says in the environment of a folder, which is its home, too; it sees no other settings."""
    env = {
        "HOME": str(folder),
        "PATH": f"{folder / 'venv/bin'}:/usr/bin:/bin",
    } | settings
    done = subprocess.run(
        command, cwd=folder, env=env, capture_output=True, text=True, encoding="utf-8"
    )
    if done.returncode:
        raise SystemExit(f"{' '.join(command)}\n{done.stdout}\n{done.stderr}")
    return done.stdout


def main(versions: list[str]) -> None:
    """Try the wheel with those versions of Python that are there."""
    if faults := disagreements(ROOT):
        raise SystemExit("\n".join(faults))
    (wheel,) = (ROOT / "dist").glob("*.whl")
    ten_lines = found(
        r"^## Ten lines of Python\s+```python\n([^`]+)",
        (ROOT / "README.md").read_text(encoding="utf-8"),
    )
    for version in versions:
        python, folder = f"python{version}", ROOT / f"build/python{version}"
        if is_there(python):
            install(python, wheel, folder)
            assert "All is well." in run_alone(folder, "rlrobot-edu", "doctor")
            assert "TOSL+QBIASSR vs TOSL+SR" in run_alone(
                folder, "python", "-c", ten_lines
            )
            print(
                f"Python {version}: the wheel installs, doctor finds nothing wrong, ten lines run",
                flush=True,
            )
        else:
            print(f"Python {version}: not found")
    page = (ROOT / "docs/howto/release.md").read_text(encoding="utf-8")
    print(
        "What is left to do",
        page.partition("## First")[2],
        sep="",
    )


if __name__ == "__main__":
    main(sys.argv[1:])
