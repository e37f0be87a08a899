# make build   derive, prove, check and write the catalogue (and the PDF where LaTeX is found)
# make test    the test suite
# make lint    ruff and mypy
# make picture the page of the README, docs/page.png, from the PDF (needs pdftoppm)
# Each creates .venv by itself; ARGS="--only cone --no-pdf" is handed on to the command.

SHELL  := /bin/bash
VENV   := .venv
PY     := $(VENV)/bin/python
ARGS   ?=
PYTHON ?= $(firstword $(foreach p,python3.11 python3 python3.12 python3.13,$(shell \
	$(p) -c 'import sys; sys.exit(sys.version_info < (3, 11))' </dev/null 2>/dev/null && echo $(p))))

export PIP_DISABLE_PIP_VERSION_CHECK := 1
export PIP_NO_INPUT := 1
# where it is set, each worker and each command compiles all modules again, half of its start
unexport PYTHONDONTWRITEBYTECODE

.PHONY: build test lint picture clean help
.DELETE_ON_ERROR:

build: $(VENV)/.derive
	$(PY) -m axiderive.cli build $(ARGS) </dev/null

test: $(VENV)/.test
	$(PY) -m pytest -n 2 --dist worksteal $(ARGS) </dev/null

lint: $(VENV)/.lint
	$(PY) -m ruff check --no-cache . </dev/null
	$(PY) -m ruff format --no-cache --check . </dev/null
	$(PY) -m mypy </dev/null

PAGE := 16
picture:
	pdftoppm -r 92 -png -singlefile -f $(PAGE) -l $(PAGE) catalogue/handbook/handbook.pdf docs/page

clean:
	rm -rf .cache .mypy_cache .ruff_cache .pytest_cache .hypothesis

help:
	@sed -n '1,/^$$/s/^# //p' Makefile

# an interrupted or moved environment is made anew; a Debian python without ensurepip gets its venv package
$(PY):
	@test -n "$(PYTHON)" || { echo "axicontact needs Python 3.11 or newer on the PATH (or make PYTHON=/path/to/python)" >&2; exit 3; }
	@$(PYTHON) -c 'import ensurepip' </dev/null 2>/dev/null || { \
	  package=python$$($(PYTHON) -c 'import sys; print("%d.%d" % sys.version_info[:2])')-venv; \
	  if [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null; then \
	    echo "installing the Debian package $$package ..."; \
	    apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $$package; \
	  else \
	    echo "$(PYTHON) cannot create environments; run: sudo apt-get install $$package" >&2; exit 3; \
	  fi; } </dev/null
	$(PYTHON) -m venv --clear $(VENV) </dev/null

INSTALL = $(PY) -m pip install --quiet --constraint constraints.txt --editable

$(VENV)/.derive: pyproject.toml constraints.txt | $(PY)
	$(INSTALL) '.[derive]' </dev/null && touch $@

$(VENV)/.test: pyproject.toml constraints.txt | $(PY)
	$(INSTALL) '.[test]' </dev/null && touch $@ $(VENV)/.derive

$(VENV)/.lint: pyproject.toml constraints.txt | $(PY)
	$(INSTALL) '.[test,lint]' </dev/null && touch $@ $(VENV)/.test $(VENV)/.derive
