"""Build the course that runs in a browser, with nothing installed: `make lite`; the site is docs/lite/_build/site.

JupyterLite is JupyterLab without a server, and Pyodide is Python in the browser. The site carries the lessons, the
library with its datasets, and the packages that Pyodide does not have. Pyodide itself, NumPy, SciPy and Matplotlib come
from Pyodide's public address when a page is opened, or from a folder that is put into the site.
"""

import argparse
import json
import re
import shutil
import subprocess
import sys
import tomllib
from importlib.metadata import version
from pathlib import Path

from rlrobot_course.learner.my_course import Notebook, blank

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
# What Pyodide lacks, in the versions that the course is tested with; `pymunk` is compiled for Pyodide by its authors.
BROUGHT = [
    "gymnasium", "farama-notifications", "ipywidgets", "jupyterlab-widgets", "comm", "pymunk", "meshcat",
    "anywidget", "psygnal", "u-msgpack-python",
]  # fmt: skip
PYODIDE = "314.0.6"  # the one that JupyterLite's kernel is made for; its Python, its platform, and where it is public:
PYTHON, PLATFORM = "3.14", "pyemscripten_2026_0_wasm32"
PUBLIC = f"https://cdn.jsdelivr.net/pyodide/v{PYODIDE}/full/pyodide.mjs"
EXTENSIONS = Path(sys.prefix) / "share/jupyter/labextensions"
WANTED = (
    "@jupyterlite/pyodide-kernel-extension",
    "@jupyter-widgets/jupyterlab-manager",
    "anywidget",
)
INSTALL = """# In the browser the toolkit is installed each time a lesson is opened. Python is slower there: some
# numbers, each with a comment, are smaller than those with which the results in the text were found.
import piplite

await piplite.install("rlrobot-edu[notebook]")
await piplite.install("meshcat", deps=False)  # for 3D films; what it needs beside is for its server"""
KERNEL = {"display_name": "Python (Pyodide)", "language": "python", "name": "python"}


def smaller_numbers() -> dict[str, dict[str, int]]:
    """What is smaller here, by lesson and name: see `lessons.toml`."""
    return tomllib.loads((HERE / "lessons.toml").read_text(encoding="utf-8"))


def write_lessons(folder: Path, notebooks: list[Path]) -> None:
    """Copies of the lessons without outputs, each with a cell that installs the toolkit, and with smaller numbers."""
    folder.mkdir(parents=True)
    for path in notebooks:
        notebook = in_browser(path, smaller_numbers().get(path.stem, {}))
        text = json.dumps(notebook, indent=1, ensure_ascii=False)
        (folder / path.name).write_text(text, encoding="utf-8")
        for picture in re.findall(
            r"\(\.\./(docs/pictures/\w+\.\w+)\)", text
        ):  # above the site's root is the root
            (folder / picture).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / picture, folder / picture)


def in_browser(path: Path, smaller: dict[str, int]) -> Notebook:
    """A lesson's notebook as it is in the browser.

    smaller: numbers by the names to which they are assigned
    Raises ValueError if a name is not assigned a number in the lesson's code exactly once.
    """
    notebook, saved = blank(path), json.loads(path.read_text(encoding="utf-8"))["cells"]
    for i, cell in enumerate(saved):
        if "not-in-browser" in cell["metadata"].get("tags", []):
            notebook["cells"][i] = recording(cell)
    code = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    for name, number in smaller.items():
        line = re.compile(rf"^{name} = (\d+)$", re.MULTILINE)
        if (
            times := sum(len(line.findall("".join(cell["source"]))) for cell in code)
        ) != 1:
            raise ValueError(
                f"lessons.toml sets {name}, which {path.name} has to assign once; it does so {times} times"
            )
        for cell in code:
            cell["source"] = line.sub(
                rf"{name} = {number}  # in the browser; elsewhere \1",
                "".join(cell["source"]),
            )
    first = notebook["cells"].index(code[0])
    notebook["cells"].insert(
        first, code[0] | {"id": "install", "metadata": {}, "source": INSTALL}
    )
    notebook["metadata"]["kernelspec"] = KERNEL
    return notebook


def recording(cell: Notebook) -> Notebook:
    """A code cell as a text with its saved outputs."""
    parts = [
        "This cell needs a second process, which a browser does not have. Elsewhere it did this:"
    ]
    parts.append(f"```python\n{''.join(cell['source'])}\n```")
    for output in cell["outputs"]:
        printed = f"```\n{''.join(output.get('text', ''))}```"
        parts.append("".join(output.get("data", {}).get("text/html", printed)))
    return {
        "cell_type": "markdown",
        "id": cell["id"],
        "metadata": {},
        "source": "\n\n".join(parts),
    }


def bring_pyodide(pyodide: Path, site: Path) -> None:
    """Put a Pyodide into the site, which then asks for nothing elsewhere; raises ValueError if it is another one."""
    lock = pyodide / "pyodide-lock.json"
    if (
        not lock.is_file()
        or json.loads(lock.read_bytes())["info"]["abi_version"] not in PLATFORM
    ):
        raise ValueError(
            f"{pyodide} is no Pyodide {PYODIDE}: unpack the file pyodide-{PYODIDE}.tar.bz2 of its release"
        )
    shutil.copytree(pyodide, site / "static/pyodide")
    config = json.loads((site / "jupyter-lite.json").read_bytes())
    kernel = config["jupyter-config-data"]["litePluginSettings"][
        "@jupyterlite/pyodide-kernel-extension:kernel"
    ]
    kernel |= {
        "pyodideUrl": "./static/pyodide/pyodide.mjs",
        "disablePyPIFallback": True,
    }
    (site / "jupyter-lite.json").write_text(json.dumps(config), encoding="utf-8")


def fetch_wheels(folder: Path) -> None:
    """The library's wheel, and those of the packages that it needs and Pyodide lacks."""
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "-q"]
    subprocess.run(
        [*pip, "wheel", "--no-deps", "-w", str(folder), str(ROOT)], check=True
    )
    tags = ["--only-binary=:all:", "--implementation=cp", f"--python-version={PYTHON}"]
    tags += [f"--abi=cp{PYTHON.replace('.', '')}", f"--platform={PLATFORM}"]
    pinned = [f"{name}=={version(name)}" for name in BROUGHT]
    subprocess.run(
        [*pip, "download", "--no-deps", *tags, "-d", str(folder), *pinned], check=True
    )


def main() -> None:
    parser = argparse.ArgumentParser(
        description="Build the course that runs in a browser."
    )
    parser.add_argument(
        "build",
        type=Path,
        nargs="?",
        default=HERE / "_build",
        help="folder for all that is made",
    )
    parser.add_argument(
        "--pyodide",
        type=Path,
        help="folder of an unpacked Pyodide, for a site that asks nobody else",
    )
    given = parser.parse_args()
    build, site = given.build.resolve(), given.build.resolve() / "site"
    shutil.rmtree(build, ignore_errors=True)
    write_lessons(build / "content", sorted((ROOT / "notebooks").glob("*.ipynb")))
    write_lessons(
        build / "content/homework",
        sorted((ROOT / "notebooks/homework").glob("*.ipynb")),
    )
    fetch_wheels(build / "wheels")
    command = [
        sys.executable,
        "-m",
        "jupyterlite_core",
        "build",
        "--lite-dir",
        str(HERE),
    ]
    command += ["--contents", str(build / "content"), "--output-dir", str(site)]
    command += [f"--LiteBuildConfig.cache_dir={build / 'cache'}"]
    command += [
        "--apps",
        "lab",
        "--no-sourcemaps",
        "--ignore-sys-prefix",
    ]  # what else is installed is no part of it
    command += [
        f"--LiteBuildConfig.federated_extensions={EXTENSIONS / name}" for name in WANTED
    ]
    command += [
        f"--piplite-wheels={wheel}"
        for wheel in sorted((build / "wheels").glob("*.whl"))
    ]
    subprocess.run(command, cwd=build, check=True)
    if given.pyodide:
        bring_pyodide(given.pyodide, site)
    start = (HERE / "start.html").read_text(encoding="utf-8")
    where = "static/pyodide/pyodide.mjs" if given.pyodide else PUBLIC
    (site / "index.html").write_text(
        start.replace("PYODIDE_URL", where), encoding="utf-8"
    )


if __name__ == "__main__":
    main()
