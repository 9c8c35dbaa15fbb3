# The course's commands. They prepare their own environment in .venv the first time; what only teachers, the web page and
# the tests need is added when one of these is asked for.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/ready
MORE := $(VENV)/more

.PHONY: course test notebooks site assignment slides load picture lint bench check-hard browser clean

course: $(READY)          ## open the course in JupyterLab
	JUPYTER_CONFIG_PATH="$(CURDIR):$$JUPYTER_CONFIG_PATH" $(BIN)/jupyter lab notebooks/00-start-here.ipynb

test: $(MORE) $(if $(CI),browser)          ## lint, unit tests, lessons, browser
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/python -m pytest -n 2

notebooks: $(READY)       ## execute every lesson again, in place
	$(BIN)/python tools/notebooks.py

site: $(MORE)             ## the course as a web page, in build/site; then all its pages, links and sliders are tried
	$(BIN)/python tools/site.py
	KFLEARN_SITE=build/site $(BIN)/python -m pytest -n 2 --dist=load tests/test_site.py

assignment: $(MORE)       ## exercises of LESSONS="04 05" for nbgrader, in build/assignment; with ANSWERS=folder they are graded
	$(BIN)/python tools/assignment.py $(or $(LESSONS),04) $(if $(ANSWERS),--grade "$(ANSWERS)")

slides: $(MORE)           ## slides of LESSON=04, in build/slides
	$(BIN)/python tools/slides.py $(or $(LESSON),04)

load: $(MORE)             ## a class of KERNELS=30 on this machine: memory, and time from slider to picture
	$(BIN)/python tools/load.py $(KERNELS)

picture: $(MORE)          ## the picture in README.md, from JupyterLab in a browser
	$(BIN)/python tools/picture.py

lint: $(READY)
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

bench: $(MORE)            ## measure speed, memory and the whole test run: a quarter of an hour; writes BENCHMARKS.md
	$(BIN)/python bench/report.py

check-hard: $(MORE)       ## try to break everything: minutes, one table (PARTS="numbers inputs" for some of it)
	$(BIN)/python -m hard $(PARTS)

# On a CI machine without a browser: install Debian's, so that the browser tests run there too.
browser:
	command -v chromium || command -v chromium-browser || command -v google-chrome \
	  || (apt-get update -qq && apt-get install -y -qq chromium)

$(READY): requirements.txt pyproject.toml
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --requirement requirements.txt
	$(BIN)/python -m pip install --quiet --no-deps --editable .
	touch $(READY)

$(MORE): requirements-more.txt $(READY)
	$(BIN)/python -m pip install --quiet --requirement requirements-more.txt
	touch $(MORE)

clean:
	rm -rf $(VENV) build *.egg-info .pytest_cache .ruff_cache .hypothesis
