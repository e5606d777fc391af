#!/usr/bin/env bash
# Python in WebAssembly for tests/test_lite.py: npm's packages of Pyodide and of a NumPy that goes with it, unpacked.
#
#     tests/unpack_pyodide.sh FOLDER
#     RLROBOT_EDU_PYODIDE=FOLDER make test
#
# Not the Pyodide of the course in the browser: of that one npm has no NumPy.
set -euo pipefail

if [ $# -ne 1 ]; then
    echo "usage: tests/unpack_pyodide.sh FOLDER" >&2
    exit 2
fi
mkdir -p "$1"
cd "$1"
npm pack --silent pyodide@0.27.7 @emscripten-forge/numpy@2.0.1-py312h4e66579-0 >/dev/null
for archive in *.tgz; do
    tar --extract --gzip --file "$archive"
done
rm ./*.tgz
mv package/pkg/numpy-*.tar.gz package/numpy.tar.gz
