# The course's commands; `make help` lists them. They prepare their own environment in .venv the first time; what only
# teachers, the web page and the tests need is added when one of these is asked for.

PYTHON ?= $(firstword $(shell command -v python3 python py) python3)
VENV := .venv
LITE := .venv-lite
WASM := .venv-wasm
WORKERS := 2
BIN := $(VENV)/bin
READY := $(VENV)/ready
MORE := $(VENV)/more
FIRST := 00-start-here.ipynb
ROOT := $(if $(filter 0,$(shell id -u)),--allow-root)
TESTS := $(BIN)/python -m pytest -n $(WORKERS)
QUICK := $(addprefix tests/,core models results filters fitting targets course test_house.py test_import.py) kflearn
SITE := $(addprefix tests/dev/test_,site.py page.py named.py equations.py access.py)
define ROOT_NOTE
@echo "You are root, as in a container or in WSL: JupyterLab is told that this is meant."
@echo "If no browser opens, open the address that JupyterLab prints."
endef

.PHONY: help course update reset clear quick test notebooks site pdf assignment slides load picture lite wasm lint bench check-hard findings atlas wheel browser clean

help:                     ## this list
	@grep -E '^[a-z-]+:.*## ' Makefile | sed -E 's/:.*## /\t/' | awk -F '\t' '{ printf "make %-12s %s\n", $$1, $$2 }'

course: $(READY)          ## open the course in JupyterLab
	$(if $(ROOT),$(ROOT_NOTE))
	JUPYTER_CONFIG_PATH="$(CURDIR):$$JUPYTER_CONFIG_PATH" $(BIN)/jupyter lab $(ROOT) --LabApp.default_url=/lab/tree/$(FIRST) notebooks

update: $(READY)          ## what is new in the course; your answers stay
	@$(BIN)/python -m dev.update
	@$(MAKE) --no-print-directory --silent $(READY)

reset: $(READY)           ## a lesson as it was when it came, LESSON=05; what you made of it is kept beside it
	@$(BIN)/python -m dev.reset $(LESSON)

clear: $(READY)           ## the lessons without outputs, for a class, in build/clear
	rm -rf build/clear && mkdir -p build/clear && cp -r notebooks/appendix-*.md notebooks/pictures build/clear
	$(BIN)/jupyter nbconvert --log-level=WARN --ClearOutputPreprocessor.enabled=True --to notebook --output-dir build/clear notebooks/[0-9][0-9]-*.ipynb

quick: $(MORE)            ## what is tried in less than a minute: style, the house, filters and all they stand on
	@$(BIN)/python -m dev.lessons
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/python -m pytest -n $(WORKERS) -q --dist=worksteal -m "not slow" $(QUICK)

test: $(MORE) $(if $(CI),browser)          ## for an untouched clone: style, types, unit tests, examples, lessons, browser
	@$(BIN)/python -m dev.lessons
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/python -m mypy
	$(TESTS) || { [ $$? = 3 ] && $(TESTS); }  # 3: pytest itself broke, and some tests were not run

notebooks: $(READY)       ## execute every lesson again, in place
	$(BIN)/python -m dev.notebooks

site: $(MORE)             ## the course as a web page, in build/site, with its tests: about ten minutes on two cores
	$(BIN)/python -m dev.web.build
	KFLEARN_SITE=build/site $(BIN)/python -m pytest -n $(WORKERS) --dist=load $(SITE)

pdf: $(MORE)              ## that page as one PDF, in build/course.pdf
	$(BIN)/python -m dev.web.pdf

lite: $(MORE) $(LITE)/ready ## the course as a site that runs in a browser, in build/lite, with its tests; PYODIDE=folder: for offline
	$(LITE)/bin/python -m dev.lite.build $(if $(PYODIDE),--pyodide "$(PYODIDE)")
	KFLEARN_LITE=build/lite $(BIN)/python -m pytest -q tests/dev/test_lite.py

wasm: $(WASM)/ready       ## all lessons, or LESSONS="04 05", under WebAssembly without a browser: a quarter of an hour
	$(WASM)/bin/python -m dev.lite.wasm $(LESSONS)

assignment: $(MORE)       ## exercises of LESSONS="04 05" for nbgrader, in build/assignment; with ANSWERS=folder they are graded
	$(BIN)/python -m dev.teaching.assignment $(or $(LESSONS),04) $(if $(ANSWERS),--grade "$(ANSWERS)")

slides: $(MORE)           ## slides of LESSON=04, in build/slides
	$(BIN)/python -m dev.teaching.slides $(or $(LESSON),04)

load: $(MORE)             ## a class of KERNELS=30 on this machine: memory, and time from slider to picture
	$(BIN)/python -m dev.teaching.load $(KERNELS)

picture: $(MORE)          ## the picture in README.md, from JupyterLab in a browser
	$(BIN)/python -m dev.picture

lint: $(MORE)             ## mend the style of the code, as far as ruff can, and check types
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .
	$(BIN)/python -m mypy

bench: $(MORE)            ## measure speed, memory and the whole test run: a quarter of an hour; writes BENCHMARKS.md
	$(BIN)/python -m dev.bench.report

check-hard: $(MORE)       ## try to break everything: forty minutes, one table (PARTS="values inputs" for some of it)
	$(BIN)/python -m dev.hard $(PARTS)

findings:                 ## do the surprises in other software still hold? one line each (installs packages: twenty minutes)
	@changed=0; for file in findings/*.sh; do \
	  if said=$$(sh $$file 2>&1); then echo "as described  $$file"; \
	  else echo "CHANGED       $$file"; echo "$$said" | tail -n 3; changed=1; fi; \
	done; exit $$changed

atlas: $(READY)           ## other libraries' filters on three tiny problems: writes notebooks/appendix-libraries.md
	$(BIN)/python -m dev.atlas $(ONLY)

wheel: $(READY)           ## the package as it would be published, in build/dist, tried in new environments
	$(BIN)/python -m dev.wheel

# On a CI machine without a browser: install Debian's, so that the browser tests run there too.
browser:
	command -v chromium || command -v chromium-browser || command -v google-chrome \
	  || (apt-get update -qq && apt-get install -y -qq chromium)

$(READY): requirements.txt pyproject.toml
	@command -v $(PYTHON) > /dev/null || { echo "There is no Python here. The course needs Python 3.11 to 3.14: see Start in README.md."; exit 1; }
	@$(PYTHON) -m dev.prepare --folder $(VENV)

$(MORE): requirements-more.txt $(READY)
	@$(PYTHON) -m dev.prepare --folder $(VENV) requirements-more.txt
	@touch $(MORE)

# The tools of these two are for one command each: they do not come into the course's environment.
$(LITE)/ready $(WASM)/ready: .venv-%/ready: requirements-%.txt requirements.txt $(READY)
	$(BIN)/python -m venv .venv-$*
	.venv-$*/bin/python -m pip install --quiet --requirement requirements-$*.txt
	@touch $@

clean:                    ## remove the environment and what was built; lessons, answers and points stay
	@[ ! -d $(VENV) ] || echo "removing $(VENV): this may take a minute"
	@rm -rf $(VENV) $(LITE) $(WASM) *.egg-info .pytest_cache .ruff_cache .mypy_cache .hypothesis
	@[ ! -d build ] || echo "removing what was built"
	@[ ! -d build ] || find build -mindepth 1 -maxdepth 1 ! -name assignment ! -name class -exec rm -rf {} +
	@[ ! -d build ] || rmdir build 2> /dev/null || echo "build/ keeps what belongs to a class: $$(ls build | tr '\n' ' ')"
