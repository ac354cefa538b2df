# make demo       set up, compile every example, expose a still and a clip, say where the pictures are
# make test       set up the test environment (torch included); lint, types and tests
# make quick      lint and the tests of the compiler's front and of the house: within a minute
# make test-long  the tests that `make test` leaves out because each takes a second or more
# make test-pages what docs, messages and README show, run as it stands
# make test-site  the site that `make docs` built, in a browser
# make test-slow  the tests that take minutes
# make docs       the site in build/site: runs the tutorials, draws the gallery; some minutes.
#                 NSCC_SITE_URL=https://... adds a picture to previews of links
# make bench      measure: speed beside numpy, words of logic beside the best known; minutes
# make vsix      the extension for VS Code in build/nscc.vsix: needs npm
# make editor    the editor component of the playground page, which the repository keeps: needs npm
# make mutants    change product code in 40 places, one at a time, and see whether tests notice: an hour
# make lint       ruff; make types: mypy; make format: put right what ruff can
# make clean      remove what was built; the environment stays
#
# PYTHON=python3.12 chooses the interpreter (3.11 or newer), VENV=.. and OUT=.. the folders.

PYTHON ?= python3
VENV ?= .venv
OUT ?= build

SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:

BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip --disable-pip-version-check install --quiet --constraint constraints.txt
EXAMPLES := $(wildcard examples/*.nsl)
BUILT := $(EXAMPLES:examples/%.nsl=$(OUT)/%.icw)
SOURCES := $(shell find cli nscc runtime training grammars -name '*.py' -o -name '*.toml' -o -name '*.lark')

.PHONY: help demo test quick test-long test-pages test-site test-slow bench docs linkcheck mutants pictures figures vsix editor lint format types clean

help:
	@sed -n '1,/^$$/s/^# \{0,1\}//p' Makefile

$(VENV)/.made:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { \
	  echo "nscc needs Python 3.11 or newer; '$(PYTHON)' is $$($(PYTHON) --version 2>&1)." >&2; \
	  echo "Name another one: make PYTHON=python3.12" >&2; exit 1; }
	@echo "making $(VENV)"
	$(PYTHON) -m venv $(VENV)
	@touch $@

# The build backend comes first, so that the environment needs no network once it stands.
$(VENV)/.installed: $(VENV)/.made pyproject.toml constraints.txt
	@echo "installing nscc"
	$(PIP) hatchling
	$(PIP) --no-build-isolation --editable '.[run,view]'
	@touch $@

$(VENV)/.test-installed: $(VENV)/.installed
	@echo "installing the test environment, torch included: this takes some minutes, once"
	$(PIP) --no-build-isolation --editable '.[test]'
	@touch $@

$(VENV)/.docs-installed: $(VENV)/.installed
	@echo "installing what makes the site, torch included: this takes some minutes, once"
	$(PIP) --no-build-isolation --editable '.[docs]'
	@touch $@

# Compiled ahead, so that no command has to wait for a compiler, even where Python may not cache.
$(VENV)/.compiled: $(VENV)/.installed $(wildcard runtime/nscc_runtime/*/*.py training/nscc_training/baselines/*.py)
	@echo "compiling the emulator's loops"
	$(BIN)/python -m nscc_runtime.compile_ahead nscc_runtime nscc_training
	$(BIN)/python -m compileall -q nscc cli/nscc_cli runtime/nscc_runtime training/nscc_training
	@touch $@

$(OUT)/%.icw: examples/%.nsl $(VENV)/.compiled $(SOURCES)
	@mkdir -p $(OUT)
	$(BIN)/nscc build $< -o $@

# A million electrons over the frame: 33 full wells, which only the short exposures survive.
demo: $(BUILT)
	$(BIN)/nscc run $(OUT)/hdr_2x2.icw --scene builtin:hdr --exposure 1000000 \
	  -o $(OUT)/hdr.npz --png $(OUT)/hdr.png
	$(BIN)/nscc run $(OUT)/flutter.icw --scene builtin:motion --exposure 400000 \
	  -o $(OUT)/motion.npz --png $(OUT)/motion.png
	$(BIN)/nscc view $(OUT)/hdr_2x2.icw -o $(OUT)/hdr_shutters.png
	$(BIN)/nscc view $(OUT)/flutter.icw -o $(OUT)/motion_shutters.png
	$(BIN)/nscc demo -o $(OUT)
	@echo
	@echo "pictures in $(abspath $(OUT)):"
	@echo "  hdr.png              a still of five decades of light, through a 2 x 2 tile of exposures"
	@echo "  hdr_shutters.png     when its pixels are open, and where"
	@echo "  motion.png           a fast scene in one frame, every pixel with its own moment"
	@echo "  motion_shutters.png  when its pixels are open, and where"
	@echo "  picture_sheet.png    the still through four exposures, and reconstructed;"
	@echo "                       above it through pixels that look at the light, without a decoder"
	@echo "  clip_sheet.png       the same of a clip: clip.gif and clip.mp4 move"
	@echo "nscc demo PHOTO does that with a photo or a clip of yours"

lint: $(VENV)/.test-installed
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

types: $(VENV)/.test-installed
	$(BIN)/mypy

format: $(VENV)/.test-installed
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

# A process a core: torch's own threads would wait for each other.
PYTEST = OMP_NUM_THREADS=1 $(BIN)/pytest --numprocesses auto --dist loadgroup

test: lint types $(VENV)/.compiled
	$(PYTEST) -m "not long and not pages and not site and not slow"

test-long: $(VENV)/.test-installed $(VENV)/.compiled
	$(PYTEST) -m "long and not pages and not site and not slow"

# What breaks most often and is told soonest: language, messages, words, layout of the packages.
QUICK := tests/e2e/test_cases.py tests/e2e/test_imports.py \
  $(patsubst %,tests/unit/%,cli/test_main.py cli/test_support.py cli/test_containers.py nscc/test_files.py \
  $(addprefix nscc/,chips diagnostics program syntax toml words))

quick: lint
	$(BIN)/pytest --quiet --numprocesses auto --dist loadgroup $(QUICK)

# What pages show, run as it stands.
test-pages: $(VENV)/.test-installed $(VENV)/.compiled
	$(PYTEST) -m "pages and not slow"

test-site: $(VENV)/.test-installed
	$(BIN)/pytest --quiet -m site tests/site

test-slow: $(VENV)/.test-installed $(VENV)/.compiled
	$(PYTEST) -m slow

# SEED chooses the places; the first run of a commit records what each file of tests runs.
SEED ?= 1
mutants: $(VENV)/.test-installed $(VENV)/.compiled
	$(BIN)/python tests/helpers/mutants.py --seed $(SEED) --build $(OUT)

bench: $(VENV)/.test-installed $(VENV)/.compiled
	$(PIP) --no-build-isolation --editable '.[bench,test]'
	@status=0; for file in tests/benchmarks/bench_*.py; do \
	  echo "$$file"; $(BIN)/python $$file || status=1; done; exit $$status

# Sources are the repository's own pages; a warning is an error. Tutorials find nscc on the path.
SITE = PATH="$(abspath $(BIN)):$$PATH" $(BIN)/sphinx-build --quiet --fail-on-warning --keep-going \
  --conf-dir docs --doctree-dir $(OUT)/site-trees

# The emulator's loops for the playground, as WebAssembly.
$(OUT)/loops.wasm: $(VENV)/.docs-installed $(wildcard runtime/nscc_runtime/*.py runtime/nscc_runtime/*/*.py)
	@mkdir -p $(OUT)
	$(BIN)/python -m nscc_runtime.compile_ahead --wasm $@

docs: $(VENV)/.docs-installed $(VENV)/.compiled $(OUT)/loops.wasm
	$(SITE) --builder html . $(OUT)/site
	@echo "the site: $(abspath $(OUT))/site/index.html"

# Asks every server that a page names: not a part of what every change has to pass.
linkcheck: $(VENV)/.docs-installed $(VENV)/.compiled
	$(SITE) --builder linkcheck . $(OUT)/site-links

# Those that pages keep beside them, for who reads them as files.
pictures: $(VENV)/.docs-installed $(VENV)/.compiled
	PYTHONPATH=docs $(BIN)/python -m nscc_site

# Measures what pages show, and prints it into them. Minutes, on a machine that does nothing else.
PAGES ?= docs/emulator.md docs/tradeoff.md
figures: $(VENV)/.test-installed $(VENV)/.compiled
	$(BIN)/python docs/figures.py $(PAGES)

# What it is made with comes from npm, and stays in $(OUT).
vsix:
	@command -v npm >/dev/null || { echo "npm is missing: it brings what the extension is made of" >&2; exit 1; }
	rm -rf $(OUT)/vscode
	mkdir -p $(OUT)
	cp -R editors/vscode $(OUT)/vscode
	cp LICENSE $(OUT)/vscode
	cd $(OUT)/vscode && npm ci --no-audit --no-fund --silent && npm run --silent package -- --out ../nscc.vsix

editor:
	cd editors/playground && npm ci --no-audit --no-fund --silent && npm run --silent build

clean:
	rm -rf $(OUT) docs/generated dist .pytest_cache .mypy_cache .ruff_cache .hypothesis
