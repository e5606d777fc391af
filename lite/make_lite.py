"""Build the course that runs in a browser, with nothing installed: `make lite`; the site is lite/_build/site.

JupyterLite is JupyterLab without a server, and Pyodide is Python in the browser. The site carries the lessons, the
library with its datasets, and the packages that Pyodide does not have. Pyodide itself, NumPy, SciPy and Matplotlib come
from Pyodide's public address when a page is opened.
"""

import json
import re
import shutil
import subprocess
import sys
import tomllib
from importlib.metadata import version
from pathlib import Path

from jupyterlite_pyodide_kernel.constants import PYODIDE_PYTHON_VERSION

from rlrobot_course.my_course import blank

HERE = Path(__file__).parent
ROOT = HERE.parent
# What Pyodide lacks, in the versions that the course is tested with; `pymunk` is compiled for Pyodide by its authors.
BROUGHT = [
    "gymnasium", "farama-notifications", "ipywidgets", "jupyterlab-widgets", "comm", "pymunk", "meshcat",
    "anywidget", "psygnal",
]  # fmt: skip
PLATFORM = "pyemscripten_2026_0_wasm32"  # Pyodide's, of the Python above
EXTENSIONS = Path(sys.prefix) / "share/jupyter/labextensions"
WANTED = ("@jupyterlite/pyodide-kernel-extension", "@jupyter-widgets/jupyterlab-manager", "anywidget")
INSTALL = """# In the browser the toolkit is installed each time a lesson is opened.
import piplite

await piplite.install("rlrobot-edu")
await piplite.install("meshcat", deps=False)  # for 3D films; what it needs beside is for its server"""
# Opens the first lesson; the pages below it look for their settings in its script element.
START = """<!doctype html>
<html lang="en"><meta charset="utf-8"><title>RLROBOT-EDU in the browser</title>
<script id="jupyter-config-data" type="application/json" data-jupyter-lite-root=".">{}</script>
<meta http-equiv="refresh" content="0; url=lab/index.html?path=00_start_here.ipynb">
<a href="lab/index.html?path=00_start_here.ipynb">Lesson 00</a></html>
"""
LEFT_OUT = {  # lessons that make no sense in a browser, and why
    "14_sample_models": "its agents learn a million steps",
    "15_reproduce_the_paper": "its tests need hundreds of agents",
    "17_planning": "its planners think for millions of steps",
    "18_real_robot": "robots are reached through sockets and processes",
}
KERNEL = {"display_name": "Python (Pyodide)", "language": "python", "name": "python"}


def differences() -> dict[str, dict]:
    """What differs in which lesson: see `lessons.toml`."""
    return tomllib.loads((HERE / "lessons.toml").read_text(encoding="utf-8"))


def write_lessons(folder: Path, notebooks: list[Path]) -> None:
    """Copies of the lessons without outputs, each with a cell that installs the toolkit, and with what differs here."""
    folder.mkdir(parents=True)
    for path in notebooks:
        if path.stem not in LEFT_OUT:
            notebook = in_browser(blank(path), differences().get(path.stem), path.name)
            text = json.dumps(notebook, indent=1, ensure_ascii=False)
            (folder / path.name).write_text(text, encoding="utf-8")
            for picture in re.findall(r"\(\.\./(docs/pictures/\w+\.\w+)\)", text):  # above the site's root is the root
                (folder / picture).parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(ROOT / picture, folder / picture)


def in_browser(notebook: dict, here: dict | None, name: str) -> dict:
    """A lesson's notebook with its differences.

    Raises ValueError if what is to be changed is not in its code exactly once.
    """
    code = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    sources = ["".join(cell["source"]) for cell in code]
    for old, new in here["changes"] if here else []:
        if sum(source.count(old) for source in sources) != 1:
            raise ValueError(f"lessons.toml changes {old!r} in {name}, where it has to be in the code exactly once")
        sources = [source.replace(old, new) for source in sources]
    for cell, source in zip(code, sources, strict=True):
        cell["source"] = source
    top = notebook["cells"].index(code[0])
    install = {"cell_type": "code", "id": "install", "metadata": {}, "outputs": [], "execution_count": None}
    notebook["cells"].insert(top, install | {"source": INSTALL})
    if here:
        told = {"cell_type": "markdown", "id": "in-the-browser", "metadata": {}}
        notebook["cells"].insert(top, told | {"source": f"> **In the browser** {here['told']}"})
    notebook["metadata"]["kernelspec"] = KERNEL
    return notebook


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
    write_lessons(build / "content/homework", sorted((ROOT / "homework").glob("*.ipynb")))
    fetch_wheels(build / "wheels")
    command = [sys.executable, "-m", "jupyterlite_core", "build", "--lite-dir", str(HERE)]
    command += ["--contents", str(build / "content"), "--output-dir", str(build / "site")]
    command += [f"--LiteBuildConfig.cache_dir={build / 'cache'}"]
    command += ["--apps", "lab", "--no-sourcemaps", "--ignore-sys-prefix"]  # what else is installed is no part of it
    command += [f"--LiteBuildConfig.federated_extensions={EXTENSIONS / name}" for name in WANTED]
    command += [f"--piplite-wheels={wheel}" for wheel in sorted((build / "wheels").glob("*.whl"))]
    subprocess.run(command, cwd=build, check=True)
    (build / "site/index.html").write_text(START, encoding="utf-8")


if __name__ == "__main__":
    main()
