"""The drives and the cold store of lesson 25."""

import numpy as np
import pytest

from kflearn import discretise, kalman_filter, nees, whiteness
from kflearn.course import clocks, cold_store


def test_drives_are_as_their_constants_say():
    some = clocks.drives(runs=2000, rng=1)
    for sensor in (some.receiver, some.wheels):
        off = sensor.z - some.truth(sensor.times) @ sensor.H.T
        assert np.var(off) == pytest.approx(sensor.R, rel=0.03)
    end = some.moments[-1]
    _, Q = discretise([[0, 1], [0, 0]], [[0], [1]], clocks.INTENSITY, end)
    F = np.array([[1, end], [0, 1]])
    wanted = F @ clocks.START.cov @ F.T + Q
    np.testing.assert_allclose(np.cov(some.x[:, -1].T) / wanted, 1, atol=0.15)
    np.testing.assert_array_equal(some.truth(some.moments[3]), some.x[:, 3])


def test_a_stream_is_in_order_of_arrival_and_loses_nothing():
    some = clocks.drives(runs=3, rng=2)
    rows = clocks.stream(some, 0.7)
    arrival, taken = np.array([row[:2] for row in rows]).T
    assert (np.diff(arrival) >= 0).all()
    assert len(rows) == 180
    places = [row for row in rows if row[0] > row[1]]
    np.testing.assert_array_equal(np.stack([row[2] for row in places], 1), some.receiver.z)
    np.testing.assert_allclose(np.unique((arrival - taken).round(9)), [0, 0.7])


@pytest.mark.parametrize("rate", [0.2, 1.0, 10.0])
def test_the_jam_is_one_drive(rate):
    receiver, wheels, times, x = clocks.jam(rate)
    np.testing.assert_allclose(np.diff(x[:, 0]), (x[1:, 1] + x[:-1, 1]) / 2 * 0.01, atol=1e-12)
    off = receiver.z - np.interp(receiver.times, times, x[:, 0])
    assert abs(off).max() < 4 and np.diff(receiver.times) == pytest.approx(1 / rate)
    assert np.std(wheels.z - np.interp(wheels.times, times, x[:, 1])) == pytest.approx(0.2, rel=0.2)


def test_the_store_is_calm_until_the_fault():
    true, faults = cold_store.recordings(runs=200, rng=3)
    first = next(iter(faults.values()))[:, : cold_store.BEFORE]
    for z in faults.values():
        np.testing.assert_array_equal(z[:, : cold_store.BEFORE], first)
    track = kalman_filter(cold_store.MODEL, first[..., None], cold_store.START)
    assert np.nanmean(track.nis) == pytest.approx(1, abs=0.02)
    assert nees(track, true[:, : cold_store.BEFORE, None])[:, -1].mean() == pytest.approx(1, abs=0.4)
    assert abs(whiteness(track, 1)).max() < 0.02


def test_what_happens_is_what_the_names_say():
    true, faults = cold_store.recordings(runs=400, rng=4)
    late = {name: (z - true)[:, cold_store.BEFORE :] for name, z in faults.items()}
    assert late["offset of 3 σ"].mean() == pytest.approx(0.6, abs=0.01)
    assert late["noise doubled"].std() == pytest.approx(0.4, rel=0.02)
    assert np.ptp(faults["stuck"][:, cold_store.BEFORE :], axis=1).max() == 0
    assert late["drift, 0.3 °C/h"][:, -1].mean() == pytest.approx(0.9, abs=0.05)


def test_without_an_alarm_all_answers_are_the_kalman_filter():
    z = cold_store.recordings(runs=5, rng=5)[1]["stuck"][:, :700]
    track = kalman_filter(cold_store.MODEL, z[..., None], type(cold_store.START)(z[:, :1], cold_store.R))
    for answer in ("nothing", "begin again", "switch off"):
        found = cold_store.respond(z, answer, limit=1e9)
        np.testing.assert_allclose(found, track.mean[..., 0], rtol=0, atol=1e-10)
