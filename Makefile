# make lab    open the course in JupyterLab, as copies in my_course/ that are yours
# make fresh LESSON=02  set your copy of a lesson back, or of an assignment, HOMEWORK=1 (the old one is kept)
# make tools  an environment of its own with all that developers need; what follows makes it when it is missing
# make test   whether all is well, in about six minutes: lint, types, and every test but the long ones
# make test LESSON=04   one lesson: its exercises, wrong answers, figures and notebook
# make test-all   the same and the long ones, twenty minutes more: browsers, ROS, packaging, all notebooks
# make test-pythons   test-all with each of Python 3.11 to 3.14 that is found, in fresh environments (some hours)
# make test-lowest   the library's tests with the lowest versions that pyproject.toml allows, in .venv-lowest
# make test-newest   the library's tests with the newest versions of everything, in .venv-newest
# make coverage   how much of the library its tests run, lines and branches; fails below 95 % (15 minutes)
# make bench  measure how fast it is, MushroomRL too (fetched for it alone); writes studies/benchmarks/README.md
# make fuzz   attack every reader and every public call (INPUTS=100000 SEED=the clock's); fails if anything is found
# make soak   find out what grows when it runs for long; ten minutes
# make reproduce  run the paper's experiments; writes docs/reproduction/ and docs/results.md (40 minutes on two quiet cores; QUICK=--quick: five;
#                 ENGINE=kinematic: the base without physics, into docs/reproduction/kinematic; of the report it
#                 writes the tables and figures: the text between them is written by hand)
# make bias-study  run what studies/bias_registered.json says; writes docs/studies/a_better_bias.md (under an hour on two quiet cores)
# make atlas  run what studies/tuning_registered.json says; writes docs/studies/how_much_tuning.md (under an hour on two busy cores;
#             stop it when you like, the same call goes on)
# make docs   the documentation site from the committed notebooks, in docs/_build/html; needs no network once installed
# make lite   the course for a browser, with nothing installed, in docs/lite/_build/site; `make docs` then takes it along
#             (PYODIDE=folder of an unpacked Pyodide: for a network that lets nothing else through)
# make release   the wheel and the source archive, in dist/; each Python that is found tries it; says what is left to do
# make size   how large the packages are; writes docs/howto/size.md
# make platforms   ask what can be installed where; writes the table of docs/howto/install.md
# make pin    take the newest versions of all packages into constraints.txt
# Each makes what it needs first. Only Python 3.11 or later must be there.

# a pipe fails when any part of it does
SHELL := bash
.SHELLFLAGS := -o pipefail -c
# where it is set, each of the many processes that the tests start compiles anew all that it imports
unexport PYTHONDONTWRITEBYTECODE

# An environment is made by the first of these that is recent enough and can make one: VENV for learners and TOOLS for
# developers, whose tools would show in a learner's JupyterLab
PYTHON ?= python3.11 python3.12 python3.13 python3.14 python3
VENV ?= .venv
TOOLS ?= .venv-tools
RUN := $(VENV)/bin/python
DEV := $(TOOLS)/bin/python
LEARNING := lab,arm,ros
# $(call install,environment,extras,dependency groups): by uv, in seconds; it knows nothing of pip's settings, and where it
# fails, pip does it. The pins hold for the build backend, too: pip before 25.3 reads the first, later ones the second.
PIP := PIP_CONSTRAINT=constraints.txt PIP_BUILD_CONSTRAINT=constraints.txt python -m pip install --disable-pip-version-check
install = PATH=$(abspath $1/bin):$$PATH; \
	{ $(PIP) -q uv && uv pip install -q --python $1/bin/python -c constraints.txt -b constraints.txt -e '.[$2]' $(3:%=--group %) 2>/dev/null; } || \
	{ $(PIP) -q 'pip>=25.1' && $(PIP) -e '.[$2]' $(3:%=--group %) $(BRIEFLY); }
# Of what pip says, one line for each package that comes and the last one; elsewhere stand paths
BRIEFLY = | sed -n -E 's/^(Collecting [^ ]+).*/  \1/p; s/^Installing collected packages.*/  Installing them: up to a minute …/p; s/^(Successfully installed).*/  \1/p'
PYTEST := $(DEV) -m pytest --numprocesses auto --dist loadfile --no-loadscope-reorder \
	--nbval --nbval-current-env --nbval-sanitize-with tests/pictures.cfg
INPUTS ?= 100000
SEED ?= $(shell date +%s)
# make test-pythons, make release
VERSIONS ?= 3.11 3.12 3.13 3.14
# make coverage runs the tests of the library and its robots, and leaves out what is not about its lines
COVERING := tests/library tests/robots tests/ros tests/browser/test_show.py tests/browser/test_pages.py tests/course/test_grade.py
NOT_COVERING := datasets fuzz size typing docstrings
# These are about the code, and about the tools that look at it
NOT_OF_VERSIONS := size typing docstrings circles
# in these, processes may write only so much; what coverage writes is too much
CRAMPED := library/test_kernel_cache.py::test_a_new_package_learns_where_its_kernels_cannot_be_kept
# JupyterLab refuses to run as root unless it is told to
LAB_FLAGS ?= $(if $(filter 0,$(shell id -u)),--allow-root)

.PHONY: lab fresh test test-long test-all test-pythons test-lowest test-newest coverage bench size soak fuzz reproduce bias-study atlas datasets pictures notebooks docs lite release tools pin platforms clean

lab: $(VENV)/lab.done
	$(RUN) -m rlrobot_edu lab $(LAB_FLAGS)

fresh: $(VENV)/lab.done
	$(RUN) -m rlrobot_edu fresh $(if $(HOMEWORK),homework $(HOMEWORK),$(LESSON))

ifdef LESSON
test: $(TOOLS)/tools.done
	$(DEV) -m rlrobot_edu course check $(LESSON)
else
test: $(TOOLS)/tools.done
	$(DEV) -m rlrobot_edu compile & \
	$(DEV) -m ruff check . && $(DEV) -m ruff format --check . && \
	$(TOOLS)/bin/lint-imports --no-cache && $(TOOLS)/bin/mypy && wait $$!
	$(if $(LONG),RLROBOT_EDU_LONG=1) $(PYTEST) $(SOME) tests notebooks
endif

# LONG=1: with what asks the world outside, and what takes twenty minutes more
SOME = -m "not long"
test-long: SOME = -m long
test-all: SOME =
test-long test-all: test

# Where a version stands behind pyenv: PATH=~/.pyenv/versions/3.12.1/bin:$PATH make test-pythons
test-pythons:
	@rm -rf .venv-3.*; passed=; failed=; absent=; \
	for version in $(VERSIONS); do \
		python=python$$version; \
		if ! $$python -c 'import ensurepip' 2>/dev/null; then absent="$$absent $$version"; continue; fi; \
		if $(MAKE) test-all TOOLS=.venv-$$version PYTHON=$$python; then passed="$$passed $$version"; \
		else failed="$$failed $$version"; fi; \
	done; \
	echo "Python: passed$${passed:- none}; failed$${failed:- none}; not found$${absent:- none}"; \
	test -z "$$failed" -a -n "$$passed"

# Neither constraints.txt nor [tool.uv], which uv would read in this folder, holds here
test-lowest: RESOLUTION = lowest-direct
test-newest: RESOLUTION = highest
test-lowest test-newest: test-%: $(TOOLS)/tools.done
	rm -rf .venv-$*
	$(DEV) -m uv venv --quiet --python $(DEV) .venv-$*
	cd / && $(abspath $(DEV)) -m uv pip install --quiet --upgrade --python $(CURDIR)/.venv-$* --resolution $(RESOLUTION) \
		--only-binary :all: --no-binary rlrobot-edu -e '$(CURDIR)[all]' --group $(CURDIR)/pyproject.toml:test
	.venv-$*/bin/python -m rlrobot_edu doctor
	.venv-$*/bin/python -m pytest --numprocesses auto --dist loadfile --no-loadscope-reorder -m "not long" \
		$(NOT_OF_VERSIONS:%=--ignore-glob='tests/*/test_%.py') tests/library

coverage: $(TOOLS)/tools.done
	$(DEV) -m rlrobot_edu compile
	rm -f .coverage .coverage.*
	$(DEV) -m pytest --numprocesses auto --dist loadfile --no-loadscope-reorder --cov --cov-fail-under=95 \
		$(NOT_COVERING:%=--ignore-glob='tests/*/test_%.py') --deselect tests/$(CRAMPED) $(COVERING)
	rm -f .coverage.*

bench: $(TOOLS)/tools.done
	$(DEV) studies/benchmarks/bench.py

size: $(TOOLS)/tools.done
	$(DEV) studies/size.py

soak: $(TOOLS)/tools.done
	$(DEV) tests/soak.py

fuzz: $(TOOLS)/tools.done
	$(DEV) -c "import atheris" 2>/dev/null || PATH=$(TOOLS)/bin:$$PATH $(PIP) -q atheris || true  # without it hypothesis alone attacks
	$(DEV) tests/fuzz/run.py --inputs $(INPUTS) --seed $(SEED)

reproduce: $(VENV)/lab.done
	$(RUN) studies/reproduce.py $(QUICK) $(if $(ENGINE),--engine $(ENGINE))

bias-study: $(VENV)/lab.done
	$(RUN) studies/better_bias.py power
	$(RUN) studies/better_bias.py all

atlas: $(VENV)/lab.done
	$(RUN) studies/how_much_tuning.py all

datasets: $(VENV)/lab.done
	$(RUN) datasets/make_datasets.py

pictures: $(VENV)/lab.done
	$(RUN) docs/site/make_pictures.py $(TASKS)

# run all notebooks and assignments and keep their outputs, as they are committed
notebooks: $(VENV)/lab.done
	$(RUN) notebooks/run_all.py

docs: $(TOOLS)/tools.done
	$(DEV) docs/site/make_site.py

tools: $(TOOLS)/tools.done

lite: $(TOOLS)/tools.done
	$(DEV) docs/lite/make_lite.py $(PYODIDE:%=--pyodide %)

release: $(TOOLS)/tools.done
	rm -rf dist
	$(DEV) -m build --no-isolation
	$(DEV) -m twine check --strict dist/*
	$(DEV) tests/release/try_wheel.py $(VERSIONS)

# the newest versions that go together become the tested ones: wheels only, one list for all platforms and Pythons
pin: $(TOOLS)/tools.done
	$(DEV) -m uv pip compile --quiet --upgrade --universal --python-version 3.11 --fork-strategy fewest --only-binary :all: \
		--no-header --no-annotate --no-emit-index-url pyproject.toml --extra all --group test --group docs --group lite \
		--group fuzz --group baselines -o constraints.txt

platforms: $(TOOLS)/tools.done
	$(DEV) docs/site/platforms.py

clean:
	rm -rf .venv .venv-* build dist docs/_build docs/lite/_build .coverage .coverage.*
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

# Debian's Python without python3-venv leaves half an environment behind when it fails
%/bin/python:
	@echo "Making a virtual environment in $* …"
	@for python in $(PYTHON); do \
		$$python -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || continue; \
		$$python -m venv --clear $* && exit; \
		rm -rf $*; \
	done; \
	echo "None of '$(PYTHON)' is Python 3.11 or later and can make a virtual environment."; \
	echo "Install one: sudo apt install python3 python3-venv (Ubuntu 22.04: python3.11 python3.11-venv)"; \
	exit 1

$(VENV)/lab.done: $(VENV)/bin/python pyproject.toml constraints.txt
	@echo "Installing into $(VENV): this happens once and takes up to a minute or two …"
	@$(call install,$(VENV),$(LEARNING))
	@touch $@

$(TOOLS)/tools.done: $(TOOLS)/bin/python pyproject.toml constraints.txt
	@echo "Installing the course and what its tests need into $(TOOLS): this happens once and takes some minutes …"
	@$(call install,$(TOOLS),all,test docs lite)
	@touch $@
