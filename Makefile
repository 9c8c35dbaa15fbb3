# The course's commands. `make course` and `make test` prepare their own environment in .venv the first time.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/ready

.PHONY: course test notebooks lint bench browser clean

course: $(READY)          ## open the course in JupyterLab
	JUPYTER_CONFIG_PATH="$(CURDIR):$$JUPYTER_CONFIG_PATH" $(BIN)/jupyter lab notebooks/00-start-here.ipynb

test: $(READY) $(if $(CI),browser)          ## lint, unit tests, lessons, browser
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/python -m pytest -n 2

notebooks: $(READY)       ## execute every lesson again, in place
	$(BIN)/python tools/notebooks.py

lint: $(READY)
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

bench: $(READY)           ## print the tables of speed: filters, then playground
	$(BIN)/python bench/filters.py
	$(BIN)/python bench/playground.py

# On a CI machine without a browser: install Debian's, so that the browser tests run there too.
browser:
	command -v chromium || command -v chromium-browser || command -v google-chrome \
	  || (apt-get update -qq && apt-get install -y -qq chromium)

$(READY): requirements.txt pyproject.toml
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --requirement requirements.txt
	$(BIN)/python -m pip install --quiet --no-deps --editable .
	touch $(READY)

clean:
	rm -rf $(VENV) build *.egg-info .pytest_cache .ruff_cache .hypothesis
