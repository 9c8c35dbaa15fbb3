"""The linear systems against runs of the published programs (GNU Octave), stored in tests/reference."""

from pathlib import Path

import numpy as np
import pytest

from kflearn import Gaussian, LinearModel, correct, kalman_filter, predict, scenarios, start_from

FOLDER = Path(__file__).parents[1] / "reference"


def read(name):
    return np.genfromtxt(FOLDER / f"{name}.csv", delimiter=",", names=True)


def columns(table, names):
    return np.stack([table[name] for name in names.split()], axis=-1)[1:]


def agree(found, reference):
    np.testing.assert_allclose(found, reference, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("row", read("cart"), ids=lambda row: f"H2={row[0]:g} Q11={row[1]:g} v={row[2]:g}")
def test_cart_with_each_published_mistake(row):
    # The wrong speed was typed into the prediction only, so it is put into F's product by hand here.
    model = LinearModel(F=[[1, 1], [0, 1]], H=[[1, row["H2"]]], Q=np.diag([row["Q11"], 0]), R=1)
    prior = predict(model, Gaussian([50, 10], np.diag([1, 0])))
    agree(prior.cov[0, 0], row["Pminus11"])
    after = correct(model, Gaussian([60, row["v_pred"]], prior.cov), 62)
    agree(after.mean, [row["x1"], row["x2"]])
    agree(after.cov[0, 0], row["Pplus11"])


def test_cart_scenario_ends_at_the_right_answer():
    scene = scenarios.cart()
    after = kalman_filter(scene.model, [62.0], scene.initial)
    agree(after.mean[0], [185 / 3, 10])
    agree(after.cov[0], [[5 / 6, 0], [0, 0]])
    agree(after.gain[0], [[5 / 6], [0]])


def test_voltmeter():
    table = read("voltmeter")
    model = scenarios.voltmeter().model
    track = kalman_filter(model, table["z"][1:], start_from(model, table["z"][0]))
    agree(track.mean, columns(table, "x_est"))
    agree(track.cov[..., 0], columns(table, "P"))
    agree(track.gain[..., 0], columns(table, "K"))


def test_temperature():
    table, scene = read("temperature"), scenarios.temperature()
    track = kalman_filter(scene.model, table["z"][1:], scene.initial)
    agree(track.mean, columns(table, "x_est"))
    agree(track.cov[..., 0], columns(table, "P"))
    agree(track.gain[..., 0], columns(table, "K"))


def test_free_fall():
    table, scene = read("free_fall"), scenarios.free_fall()
    track = kalman_filter(scene.model, table["z"][1:], scene.initial, scene.u)
    agree(track.mean, columns(table, "x_est v_est"))
    agree(track.filtered.variance, columns(table, "P11 P22"))
    agree(track.gain[..., 0], columns(table, "K1 K2"))


def test_train():
    table, scene = read("train"), scenarios.train()
    track = kalman_filter(scene.model, table["z"][1:], scene.initial)
    agree(track.mean, columns(table, "x_est v_est"))
    agree(track.cov[..., [0, 0, 1], [0, 1, 1]], columns(table, "P11 P12 P22"))
    agree(track.gain[..., 0], columns(table, "K1 K2"))


def test_ship():
    table, scene = read("ship"), scenarios.ship()
    track = kalman_filter(scene.model, columns(table, "zx zy"), scene.initial)
    agree(track.mean, columns(table, "ex evx ey evy"))
    agree(track.filtered.variance, columns(table, "P11 P22 P33 P44"))
    agree(track.gain.mT.reshape(-1, 8), columns(table, "K11 K21 K31 K41 K12 K22 K32 K42"))
