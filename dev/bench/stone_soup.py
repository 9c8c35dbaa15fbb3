"""Stone Soup's PDA, in the environment that dev/bench/targets.py makes; this file imports nothing of the course's.

    build/bench-targets/bin/python dev/bench/stone_soup.py RACE.npz RESULT.npz

RACE.npz: scans z (T, N, m), F, H (one 1 in each row), Q, R, mean and cov one step before the first scan, detection,
clutter, gate. RESULT.npz: means, covs and weights (T, N + 1) after each scan, whether a reading was inside the gate,
and seconds a scan (best of three).
"""

import datetime
import os

os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")

import sys
import time

import numpy as np
from stonesoup.dataassociator.probability import PDA
from stonesoup.hypothesiser.probability import PDAHypothesiser
from stonesoup.models.measurement.linear import LinearGaussian
from stonesoup.models.transition.linear import LinearGaussianTimeInvariantTransitionModel
from stonesoup.predictor.kalman import KalmanPredictor
from stonesoup.types.array import StateVector
from stonesoup.types.detection import Detection
from stonesoup.types.state import GaussianState
from stonesoup.types.track import Track
from stonesoup.updater.kalman import KalmanUpdater
from stonesoup.updater.probability import PDAUpdater

BEGUN, SECOND = datetime.datetime(2026, 1, 1), datetime.timedelta(seconds=1)


def parts(race):
    """The associator, the updater and the start."""
    move = LinearGaussianTimeInvariantTransitionModel(transition_matrix=race["F"], covariance_matrix=race["Q"])
    mapping = race["H"].argmax(axis=1)
    see = LinearGaussian(ndim_state=len(race["F"]), mapping=tuple(map(int, mapping)), noise_covar=race["R"])
    sensor = dict(prob_detect=float(race["detection"]), prob_gate=float(race["gate"]))
    hypothesise = PDAHypothesiser(
        KalmanPredictor(move), KalmanUpdater(see), clutter_spatial_density=float(race["clutter"]), **sensor
    )
    start = GaussianState(StateVector(race["mean"]), race["cov"], timestamp=BEGUN)
    return PDA(hypothesise), PDAUpdater(see), start, see


def detections(z, see):
    """A set of detections for each scan, and where in the scan each of them was."""
    for k, scan in enumerate(z):
        at, rows = BEGUN + (k + 1) * SECOND, scan[~np.isnan(scan).any(axis=1)]
        yield at, [Detection(StateVector(row), timestamp=at, measurement_model=see) for row in rows]


def run(race, scans):
    """Track through all scans; the hypotheses of each, and the track."""
    associator, updater, start, _ = parts(race)
    track, told = Track([start]), []
    for at, found in scans:
        hypotheses = associator.associate({track}, set(found), at)[track]
        track.append(updater.update(hypotheses))
        told.append(hypotheses)
    return track, told


def weights(told, scans, N):
    """Their probabilities in the order of the scan, "none of them" first; and which readings have a hypothesis."""
    beta, inside = np.zeros((len(told), N + 1)), np.zeros((len(told), N), bool)
    for k, (hypotheses, (_, found)) in enumerate(zip(told, scans, strict=True)):
        place = {id(detection): j for j, detection in enumerate(found)}
        for each in hypotheses:
            j = place[id(each.measurement)] if each else -1
            beta[k, j + 1] = float(each.probability)
            if j >= 0:
                inside[k, j] = True
    return beta, inside


def main(race_file, result_file):
    with np.load(race_file) as file:
        race = {name: file[name][()] for name in file.files}
    scans = list(detections(race["z"], parts(race)[3]))
    clocks = []
    for _ in range(3):
        begun = time.perf_counter()
        track, told = run(race, scans)
        clocks.append(time.perf_counter() - begun)
    beta, inside = weights(told, scans, race["z"].shape[1])
    means = np.array([np.ravel(state.mean).astype(float) for state in track[1:]])
    covs = np.array([np.asarray(state.covar, float) for state in track[1:]])
    np.savez(result_file, means=means, covs=covs, weights=beta, inside=inside, seconds=min(clocks) / len(scans))


if __name__ == "__main__":
    main(*sys.argv[1:])
