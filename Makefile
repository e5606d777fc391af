# make lab    open the course in JupyterLab
# make test   run the whole test suite
# make bench  measure how fast it is; writes benchmarks/README.md
# Each makes what it needs first. Only Python 3.11, 3.12 or 3.13 must be there.

PYTHON ?= $(firstword $(shell command -v python3.11 python3.12 python3.13 python3))
BIN := .venv/bin
PIP := $(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt
# JupyterLab refuses to run as root unless it is told to
LAB_FLAGS ?= $(if $(filter 0,$(shell id -u)),--allow-root)

.PHONY: lab test bench datasets pictures notebooks pin clean

lab: .venv/lab.done
	$(BIN)/python -m rlrobot_edu compile
	$(BIN)/jupyter lab --ip=127.0.0.1 $(LAB_FLAGS) notebooks/00_start_here.ipynb

test: .venv/lab.done .venv/test.done
	$(BIN)/python -m rlrobot_edu compile
	$(BIN)/python -m ruff check .
	$(BIN)/python -m ruff format --check .
	$(BIN)/lint-imports --no-cache
	$(BIN)/python -m pytest --nbval --nbval-current-env tests notebooks

bench: .venv/lab.done .venv/test.done
	$(BIN)/python benchmarks/bench.py

datasets: .venv/lab.done
	$(BIN)/python datasets/make_datasets.py

pictures: .venv/lab.done
	$(BIN)/python docs/make_pictures.py

# run all notebooks and keep their outputs, as they are committed
notebooks: .venv/lab.done
	$(BIN)/python notebooks/run_all.py

# the versions of a fresh environment become the tested ones
pin:
	rm -rf .pin && $(PYTHON) -m venv .pin && .pin/bin/pip install --quiet '.[lab,arm,test]'
	.pin/bin/pip freeze --exclude rlrobot-edu > constraints.txt && rm -rf .pin

clean:
	rm -rf .venv build dist
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

.venv/bin/python:
	@test -n "$(PYTHON)" || { echo "Python 3.11 or newer is needed: sudo apt install python3 python3-venv"; exit 1; }
	@$(PYTHON) -m venv .venv || { rm -rf .venv; echo "Python's venv is needed: sudo apt install python3-venv"; exit 1; }

.venv/lab.done: .venv/bin/python pyproject.toml constraints.txt
	$(PIP) -e '.[lab,arm]'
	@touch $@

.venv/test.done: .venv/lab.done
	$(PIP) -e '.[lab,arm,test]'
	@touch $@
