"""The rivals that have an environment of their own; this file runs there, and imports nothing of the course's.

    build/bench-rivals/bin/python dev/bench/rivals.py RIVAL RACE.npz RESULT.npz

RACE.npz: kind (filter, smoother, UKF or EKF), readings z (runs, T, m), sample (on how many runs a rival is timed that
takes one at a time), F, H, Q, R, the belief one step before the first reading (mean, cov) and at it (first_mean,
first_cov).
RESULT.npz: means of the runs that were filtered, seconds for all runs (best of three), first: seconds of the first
call, in which JAX compiles; cpu: seconds of all threads for one of the clock. What cannot be done is said in a line.
"""

import os

os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", JAX_ENABLE_X64="1", JAX_PLATFORMS="cpu")
os.environ.update(XLA_FLAGS="--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1")

import sys
import time

import numpy as np


def ssfortran(race):
    import ssfortran

    if race["kind"] not in ("filter", "smoother"):
        raise NotImplementedError("has linear filters only")

    def one_run(z):
        model = ssfortran.Representation(z, len(race["F"]))
        model["design"], model["transition"], model["selection"] = race["H"], race["F"], np.eye(len(race["F"]))
        model["obs_cov"], model["state_cov"] = race["R"], race["Q"]
        model.initialize_known(race["first_mean"], race["first_cov"])
        return model.smooth().smoothed_state.T if race["kind"] == "smoother" else model.filter().filtered_state.T

    return lambda z: np.stack([one_run(series) for series in z])


def their_filter(race):
    import kalman

    reason = "has no smoother" if race["kind"] == "smoother" else "not tried: it calls Python for f and h"
    if race["kind"] != "filter":
        raise NotImplementedError(reason)
    flat = [race[name].ravel().tolist() for name in ("mean", "cov", "F", "Q", "H", "R")]
    return kalman.LinearKalmanFilter(len(race["F"]), len(race["R"]), *flat)


def fast_kalman(race):
    """Mean and covariance after each reading: they have to be asked for reading by reading."""
    their_filter(race)

    def one_run(z):
        kf, means, covs = their_filter(race), [], []
        for reading in z.tolist():
            kf.update(reading)
            means.append(kf.x)
            covs.append(kf.P)
        return np.array(means), np.array(covs)

    return lambda z: np.stack([one_run(series)[0] for series in z])


def fast_kalman_end(race):
    """The whole loop in C++, which keeps the last mean and covariance only."""
    their_filter(race)

    def one_run(z):
        return their_filter(race).update_many(z)["x"]

    return lambda z: np.array([one_run(series) for series in z])[:, None]


def compiled(one_run):
    """one_run(z) → means, covariances of one run, made by JAX into a function of all runs."""
    import jax

    run = jax.jit(jax.vmap(one_run))
    return lambda z: np.asarray(jax.block_until_ready(run(z))[0])


def measure(race):
    """h in units of the noise: dynamax adds 1e-9 to S, which must be small. The EKF: two angles, the UKF: a radar."""
    import jax.numpy as jnp

    unit = np.sqrt(np.diag(race["R"]))

    def angles(x):
        return jnp.array([jnp.arctan2(x[1], jnp.hypot(x[0], x[2])), jnp.arctan2(-x[2], x[0])]) / unit

    def radar(x):
        return jnp.array([jnp.hypot(x[0], x[1]), jnp.arctan2(x[1], x[0])]) / unit

    return angles if race["kind"] == "EKF" else radar, unit, np.eye(len(unit))


def kalman_py(race):
    import kalman_py

    if race["kind"] in ("UKF", "EKF"):
        return kalman_py_nonlinear(race)
    kf = kalman_py.KalmanFilter(*(race[name] for name in ("F", "H", "Q", "R", "mean", "cov")))
    if race["kind"] == "filter":
        return compiled(lambda z: means_and_covs(kf.filter(z, backend="jax")))
    return compiled(lambda z: means_and_covs(kf.smooth(kf.filter(z, backend="jax"))))


def kalman_py_nonlinear(race):
    """The EKF takes all runs at once; the UKF looks at its covariances after each run, which JAX cannot do for many."""
    import kalman_py

    h, unit, R = measure(race)
    model = lambda x, dt: race["F"] @ x, h, race["Q"], R, race["mean"], race["cov"]
    if race["kind"] == "EKF":
        ekf = kalman_py.ExtendedKalmanFilter(*model)
        return compiled(lambda z: means_and_covs(ekf.filter(z / unit, dt=1.0, backend="jax")))
    ukf = kalman_py.UnscentedKalmanFilter(*model, alpha=0.01, beta=2.0, kappa=0.0)
    return lambda z: np.stack([np.asarray(ukf.filter(one, dt=1.0, backend="jax").means) for one in z / unit])


def means_and_covs(result):
    return result.means, result.covs


def dynamax(race):
    from dynamax.linear_gaussian_ssm import inference as linear
    from dynamax.nonlinear_gaussian_ssm import ParamsNLGSSM, UKFHyperParams, extended_kalman_filter
    from dynamax.nonlinear_gaussian_ssm import unscented_kalman_filter as unscented

    kind, F, start = race["kind"], race["F"], (race["first_mean"], race["first_cov"])
    if kind in ("UKF", "EKF"):
        h, unit, R = measure(race)
        model = ParamsNLGSSM(*start, lambda x: F @ x, race["Q"], h, R)
        points = UKFHyperParams(alpha=0.01, beta=2.0, kappa=0.0)
        run = extended_kalman_filter if kind == "EKF" else lambda model, z: unscented(model, z, points)
        return compiled(lambda z: filtered(run(model, z / unit)))
    model = linear.make_lgssm_params(*start, F, race["Q"], race["H"], race["R"])
    if kind == "filter":
        return compiled(lambda z: filtered(linear.lgssm_filter(model, z)))

    def smoothed(z):
        found = linear.lgssm_smoother(model, z)
        return found.smoothed_means, found.smoothed_covariances

    return compiled(smoothed)


def filtered(found):
    return found.filtered_means, found.filtered_covariances


RIVALS = {  # name: the function that makes a filter, and whether it takes all runs at once
    "ssfortran": (ssfortran, False),
    "fast-kalman": (fast_kalman, False),
    "fast-kalman, the end only": (fast_kalman_end, False),
    "kalman-py": (kalman_py, True),
    "dynamax": (dynamax, True),
}


def main(rival, race_file, result_file):
    with np.load(race_file) as file:
        race = {name: file[name][()] for name in file.files}
    make, at_once = RIVALS[rival]
    z, run = race["z"] if at_once else race["z"][: race["sample"]], make(race)
    clocks = []
    for _ in range(4):
        begun = time.perf_counter(), time.process_time()
        means = run(z)
        clocks.append((time.perf_counter() - begun[0], time.process_time() - begun[1]))
    seconds, cpu = min(clocks[1:])
    whole = len(race["z"]) / len(z)
    np.savez(result_file, means=means, seconds=seconds * whole, first=clocks[0][0], cpu=cpu / seconds)


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except NotImplementedError as reason:
        sys.exit(str(reason))
    except Exception as reason:
        first, *_ = str(reason).splitlines() or [""]
        sys.exit(f"{type(reason).__name__}: {first}")
