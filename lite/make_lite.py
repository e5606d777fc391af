"""Build the course that runs in a browser, with nothing installed: `make lite`; the site is lite/_build/site.

JupyterLite is JupyterLab without a server, and Pyodide is Python in the browser. The site carries the lessons, the
library with its datasets, and the packages that Pyodide does not have. Pyodide itself, NumPy, SciPy and Matplotlib come
from Pyodide's public address when a page is opened.
"""

import json
import shutil
import subprocess
import sys
import tomllib
from importlib.metadata import version
from pathlib import Path

from jupyterlite_pyodide_kernel.constants import PYODIDE_PYTHON_VERSION

from rlrobot_edu.course.my_course import blank

HERE = Path(__file__).parent
ROOT = HERE.parent
# What Pyodide lacks, in the versions that the course is tested with; `pymunk` is compiled for Pyodide by its authors.
BROUGHT = ["gymnasium", "farama-notifications", "ipywidgets", "jupyterlab-widgets", "comm", "filelock", "pymunk", "meshcat"]
PLATFORM = "pyemscripten_2026_0_wasm32"  # Pyodide's, of the Python above
INSTALL = """# In the browser the toolkit is installed each time a lesson is opened.
import piplite

await piplite.install("rlrobot-edu")
await piplite.install("meshcat", deps=False)  # for 3D films; what it needs beside is for its server"""
START = """<!doctype html>
<html lang="en"><meta charset="utf-8"><title>RLROBOT-EDU in the browser</title>
<meta http-equiv="refresh" content="0; url=lab/index.html?path=00_start_here.ipynb">
<a href="lab/index.html?path=00_start_here.ipynb">Lesson 00</a></html>
"""
KERNEL = {"display_name": "Python (Pyodide)", "language": "python", "name": "python"}


def write_lessons(folder: Path, notebooks: list[Path]) -> None:
    """Copies of the lessons without outputs, each with a cell that installs the library, and what differs here.

    Raises ValueError if what is to be changed in a lesson is not there exactly once.
    """
    differences = tomllib.loads((HERE / "lessons.toml").read_text(encoding="utf-8"))
    folder.mkdir(parents=True)
    for path in notebooks:
        notebook = in_browser(blank(path), differences.get(path.stem, {}), path.name)
        (folder / path.name).write_text(json.dumps(notebook, indent=1, ensure_ascii=False), encoding="utf-8")


def in_browser(notebook: dict, here: dict, name: str) -> dict:
    """A lesson's notebook with its changes of `lessons.toml`."""
    sources = ["".join(cell["source"]) for cell in notebook["cells"]]
    for old, new in here.get("changes", []):
        holders = [i for i, source in enumerate(sources) if old in source]
        if len(holders) != 1 or sources[holders[0]].count(old) != 1:
            raise ValueError(f"lessons.toml changes {old!r} in {name}, which has to be there exactly once")
        sources[holders[0]] = sources[holders[0]].replace(old, new)
    for cell, source in zip(notebook["cells"], sources, strict=True):
        cell["source"] = source
    first = next(i for i, cell in enumerate(notebook["cells"]) if cell["cell_type"] == "code")
    notebook["cells"].insert(first, code_cell(INSTALL))
    if "told" in here:
        notebook["cells"].insert(first, markdown_cell(f"> **In the browser.** {here['told']}"))
    notebook["metadata"]["kernelspec"] = KERNEL
    return notebook


def code_cell(source: str) -> dict:
    return {"cell_type": "code", "execution_count": None, "id": "install", "metadata": {}, "outputs": [], "source": source}


def markdown_cell(source: str) -> dict:
    return {"cell_type": "markdown", "id": "in-the-browser", "metadata": {}, "source": source}


def fetch_wheels(folder: Path) -> None:
    """The library's wheel, and those of the packages that it needs and Pyodide lacks."""
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "-q"]
    subprocess.run([*pip, "wheel", "--no-deps", "-w", str(folder), str(ROOT)], check=True)
    tags = ["--only-binary=:all:", "--implementation=cp", f"--python-version={PYODIDE_PYTHON_VERSION}"]
    tags += [f"--abi=cp{PYODIDE_PYTHON_VERSION.replace('.', '')}", f"--platform={PLATFORM}"]
    pinned = [f"{name}=={version(name)}" for name in BROUGHT]
    subprocess.run([*pip, "download", "--no-deps", *tags, "-d", str(folder), *pinned], check=True)


def main() -> None:
    build = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE / "_build"
    shutil.rmtree(build, ignore_errors=True)
    write_lessons(build / "content", sorted((ROOT / "notebooks").glob("*.ipynb")))
    fetch_wheels(build / "wheels")
    command = [sys.executable, "-m", "jupyterlite_core", "build", "--lite-dir", str(HERE)]
    command += ["--apps", "lab", "--no-sourcemaps", "--contents", str(build / "content"), "--output-dir", str(build / "site")]
    for wheel in sorted((build / "wheels").glob("*.whl")):
        command += [f"--piplite-wheels={wheel}"]
    subprocess.run(command, cwd=build, check=True)
    (build / "site/index.html").write_text(START, encoding="utf-8")


if __name__ == "__main__":
    main()
