#!/usr/bin/env bash
# Python in WebAssembly for tests/release/test_lite.py, from npm and PyPI:
#
#     tests/unpack_pyodide.sh FOLDER
#     RLROBOT_EDU_PYODIDE=FOLDER make test-all
#
# FOLDER/numpy is a Pyodide for which npm has a NumPy. FOLDER/course is that of the course in the browser, with what its
# kernel needs: plain Python in the versions of its lock, whose hashes are those of Pyodide's own builds. Neither npm
# nor PyPI has its NumPy, SciPy and Matplotlib.
set -euo pipefail

if [ $# -ne 1 ]; then
    echo "usage: tests/unpack_pyodide.sh FOLDER" >&2
    exit 2
fi
mkdir -p "$1"/{numpy,course}
cd "$1"
tar="tar --extract --gzip --strip-components 1 --file"
npm pack --silent pyodide@0.27.7 pyodide@314.0.6 @emscripten-forge/numpy@2.0.1-py312h4e66579-0 >/dev/null
$tar pyodide-0.27.7.tgz --directory numpy
$tar emscripten-forge-numpy-*.tgz --directory numpy
$tar pyodide-314.0.6.tgz --directory course
mv numpy/pkg/numpy-*.tar.gz numpy/numpy.tar.gz
rm ./*.tgz

cd course
python3 - <<'END'
import hashlib
import json
import subprocess
import sys
from pathlib import Path

lock = json.loads(Path("pyodide-lock.json").read_text())
wanted, to_do = {}, ["micropip", "ipython", "jedi"]
while to_do:
    name = to_do.pop().replace("_", "-")
    if name not in wanted:
        wanted[name] = lock["packages"][name]
        to_do += wanted[name]["depends"]
pinned = [f"{name}=={package['version']}" for name, package in wanted.items()]
download = [sys.executable, "-m", "pip", "download", "-q", "--no-deps", "--only-binary=:all:"]
subprocess.run([*download, f"--python-version={lock['info']['python']}", *pinned], check=True)
for package in wanted.values():
    package["sha256"] = hashlib.sha256(Path(package["file_name"]).read_bytes()).hexdigest()
Path("pyodide-lock.json").write_text(json.dumps(lock))
END
