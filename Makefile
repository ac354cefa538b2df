# make demo    set up, build every example, run an HDR still and a high-speed clip
# make test    set up and test: lint, types, everything not marked slow
# make bench   speed and memory, as ratios measured side by side
#
# PYTHON names the interpreter to start from (3.11 or newer).

PYTHON ?= python3
VENV := .venv
PY := $(VENV)/bin/python
NSCC := $(VENV)/bin/nscc
PIP := $(PY) -m pip install --quiet --disable-pip-version-check -c constraints.txt
OUT := build
EXAMPLES := $(wildcard examples/*.nsl)

.DEFAULT_GOAL := help
.PHONY: help demo test test-slow bench lint format grammar clean

help:
	@sed -n '1,/^$$/s/^# \{0,1\}//p' Makefile

$(PY):
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	    { echo "nscc needs Python 3.11 or newer; try: make $(MAKECMDGOALS) PYTHON=python3.12"; exit 1; }
	$(PYTHON) -m venv $(VENV)

# The emulator's loops and the modules are compiled here, so that no first run waits for them.
$(VENV)/.installed: pyproject.toml constraints.txt | $(PY)
	$(PIP) -e .
	$(PY) -m compileall -q nscc runtime training
	$(PY) -m nscc_runtime.emulator.compiled
	@touch $@

$(VENV)/.testing: $(VENV)/.installed
	$(PIP) -e '.[test,train]'
	@touch $@

demo: $(VENV)/.installed
	@mkdir -p $(OUT)
	@for file in $(EXAMPLES); do \
	    $(NSCC) build $$file -o $(OUT)/$$(basename $$file .nsl).icw --message-format short || exit 1; \
	done
	$(NSCC) run $(OUT)/hdr_2x2.icw --scene builtin:hdr -o $(OUT)/hdr.npz --png $(OUT)/hdr.png
	$(NSCC) run $(OUT)/video_16.icw --scene builtin:motion -o $(OUT)/video.npz --png $(OUT)/video.png
	$(NSCC) view examples/hdr_2x2.nsl -o $(OUT)/hdr_shutters.png --message-format short
	$(NSCC) view examples/video_16.nsl -o $(OUT)/video_shutters.png --message-format short
	@echo
	@echo "An HDR still and a high-speed clip, each from one exposure:"
	@ls $(OUT)/hdr.png $(OUT)/video.png
	@echo "and the shutters that exposed them:"
	@ls $(OUT)/hdr_shutters.png $(OUT)/video_shutters.png

lint: $(VENV)/.testing
	$(PY) -m ruff check .
	$(PY) -m ruff format --check .
	$(PY) -m mypy

test: lint
	$(PY) -m pytest -q -m "not slow"

test-slow: $(VENV)/.testing
	$(PY) -m pytest -q -m slow

bench: $(VENV)/.testing
	@for file in tests/benchmarks/bench_*.py; do $(PY) $$file || exit 1; done

format: $(VENV)/.testing
	$(PY) -m ruff check --fix .
	$(PY) -m ruff format .

# The parser's tables are made from the grammar; a test keeps the two in step.
grammar: $(VENV)/.installed
	$(PY) -m nscc.syntax.generate

clean:
	rm -rf $(VENV) $(OUT) dist .pytest_cache .mypy_cache .ruff_cache .hypothesis
