"""Can a reader of the web page reach, to the digit, every setting that the lessons name?"""

import json
import re
from types import SimpleNamespace

import nbformat
import pytest

from dev.web import build, named
from kflearn.ui.widgets import Slider
from tests.dev.web import LESSONS

pytestmark = pytest.mark.timeout(300)

# What somebody found who read the lessons, by the number of the playground.
READ = {
    "00": {1: dict(n=[10, 100], sigma=[2])},
    "28": {0: dict(ratio=[1e-6, 0.01, 0.0625, 100], night=[5, 100])},
    "01": {0: dict(force=[0], mass=[1, 10], dt=[0.25, 1, 2.5])},
    "02": {0: dict(seconds=[0, 1, 3], correlation=[-0.95])},
    "03": {0: dict(Q11=[0.01], R=[50])},
    "04": {0: dict(sigma_z=[1, 5], mean_z=[70])},
    "05": {0: dict(Q=[0.001, 0.01, 4, 400], R=[4])},
    "06": {0: dict(Q=[0.002, 0.04, 1], R=[0.07, 0.16, 0.64, 1])},
    "07": {0: dict(Q=[0.01, 1, 4, 30], R=[0.1, 1, 4, 10], runs=[1, 50])},
    "08": {0: dict(drift=[0.5, 2], Q=[200, 2000])},
    "09": {0: dict(gate=[0.5, 1, 3, 4, 8, 100], R=[500], patience=[1, 4, 15], echoes=[0, 40])},
    "10": {0: dict(g=[8, 9.8], sigma=[10], gap=[30])},
    "11": {0: dict(q=[1, 10, 1000], gap=[0, 30, 40])},
    "12": {0: dict(P0=[1e4, 1e5, 2e5, 1e7, 1e12], R=[1e-6])},
    "13": {0: dict(mean=[0, 3, 15], sigma=[0.5, 8, 10], d=[1, 50])},
    "14": {0: dict(mean=[-2, 0, 2, 4, 10], sigma=[1, 10], z=[0, 6])},
    "15": {0: dict(turn=[0, 180], minute=[4, 8], noise=[0.1, 3])},
    "16": {0: dict(sigma=[30, 400])},
    "17": {0: dict(angle=[20, 45], distance=[20], alpha=[0.001, 0.1, 1])},
    "18": {0: dict(leave=[0.003, 0.05, 0.6], turn=[0, 1], noise=[10])},
    "19": {0: dict(frame=[*range(18, 33)], q=[100, 300, 900])},
    "20": {0: dict(gap=[20, 40])},
    "21": {0: dict(sd=[0.1], tau=[0.1, 2, 1000])},
    "22": {0: dict(window=[5, 30], floor=[0.5], R=[0.01, 1, 16])},
    "23": {0: dict(now=[2, 5, 10], lag=[0, 3], sigma=[0.02])},
    "24": {0: dict(Q=[600, 1000, 3200], R=[5000, 12_000, 18_000])},
    "25": {0: dict(late=[100, 200, 300], taken_off=[0, 300], rate=[1, 5])},
    "26": {0: dict(detection=[0.5], clutter=[4e-5, 2e-4, 8e-4, 0.001])},
    "27": {0: dict(q=[0.01, 1, 100], R=[1, 100])},
    "29": {0: dict(sigma=[0.001, 10], q=[0.0001, 0.1, 10])},
}


def told(site, name):
    """What each playground of a page says about its controls, by their names."""
    scripts = re.findall(
        r'(?s)<script type="application/json">(.*?)</script>', (site / name).read_text(encoding="utf-8")
    )
    return [{control["name"]: control for control in json.loads(script)["spec"]["controls"]} for script in scripts]


@pytest.mark.parametrize("name", LESSONS)
def test_what_a_reader_is_told_to_set_is_recorded(site, name):
    for number, wanted in READ[name[:2]].items():
        controls = told(site, name)[number]
        for key, values in wanted.items():
            assert set(values) <= set(controls[key]["places"]), key


@pytest.mark.parametrize("name", LESSONS)
def test_what_is_found_in_the_text_is_recorded(site, name):
    cells = nbformat.read(build.NOTEBOOKS / f"{name[:-5]}.ipynb", as_version=4).cells
    made = [found for cell in cells for found in re.findall(r"(?m)^(\w+) = Playground\(", cell.source)]
    count = 0
    for variable, controls in zip(made, told(site, name), strict=True):
        for key, values in named.settings(playground(controls), cells, variable).items():
            assert set(values) <= set(controls[key]["places"]), key
            count += len(values)
    assert count >= (0 if name[:2] == "03" else 2)  # in lesson 3 sliders are pushed to their ends


def playground(controls):
    """Sliders as the lesson made them, from what a page tells."""
    return SimpleNamespace(controls={key: slider(c) for key, c in controls.items() if c["kind"] == "slider"})


def slider(told):
    label, step = told["plain"].replace("sigma ", "sigma_"), None if told["log"] else told["step"]
    made = Slider(told["low"], told["high"], told["places"][0], label, told["unit"], told["log"], step)
    return made.attach(told["name"])
