"""What other libraries answer, when they are asked for R and Q of the Nile by their defaults.

    python -m dev.who_fits_nile          makes build/who-fits-nile when it is first asked for: some 1.1 GB

Each is asked three times: for the hundred readings, for the same times 1000, and for white noise, whose Q is 0. They
run as pinned in who_fits_nile.txt, in an environment of their own, where this file is started once for each library
and imports nothing of the course's; StructTS runs if there is an Rscript. Writes
kflearn/course/data/who_fits_nile.csv; `kflearn.examples.who_fits_nile` says what its columns are.
"""

import csv
import json
import os
import shutil
import subprocess
import sys
import venv
from datetime import date
from importlib.metadata import version
from pathlib import Path
from typing import NamedTuple

import numpy as np

HERE = Path(__file__).parent
FOLDER, PINS = HERE.parent / "build" / "who-fits-nile", HERE / "who_fits_nile.txt"
TARGET = HERE.parent / "kflearn" / "course" / "data" / "who_fits_nile.csv"
LIMIT = 300  # seconds for one library
TIMES = 1000  # the other unit


class Answer(NamedTuple):
    """What a library says: the two variances, and nan or "-" where it says nothing.

    Where it fits a factor H before the state, Q is that of H times the state: in the unit of the readings.
    """

    R: float
    Q: float
    log_likelihood: float = np.nan
    steps: float = np.nan
    converged: str = "-"


def word(converged):
    return "yes" if converged else "no"


# ---- one function a library


def statsmodels(z, exact=False):
    from statsmodels.tsa.statespace.structural import UnobservedComponents

    found = UnobservedComponents(z, "llevel", use_exact_diffuse=exact).fit(disp=0)
    said = found.mle_retvals
    return Answer(*found.params, found.llf, said["iterations"], word(said["converged"]))


def statsmodels_exact(z):
    return statsmodels(z, exact=True)


def struct_ts(z):
    """R's own; its log-likelihood belongs to a start with a wide variance that counts."""
    script = (
        "f <- StructTS(scan('stdin', quiet = TRUE), 'level'); cat(format(c(f$coef, f$loglik, f$code), digits = 15))"
    )
    text = "\n".join(f"{value!r}" for value in z.tolist())
    said = subprocess.run(["Rscript", "-e", script], input=text, capture_output=True, text=True, check=True).stdout
    Q, R, log_likelihood, code = map(float, said.split())
    return Answer(R, Q, log_likelihood, converged=word(code == 0))


def ssfortran(z):
    from ssfortran import Irregular, Level, StructuralModel

    found = StructuralModel(z, [Irregular(), Level()]).fit()
    return Answer(*found.params, found.llf, found.niter, word(found.converged))


def kalmanbox(z):
    from kalmanbox import LocalLevel

    found = LocalLevel(z).fit()
    return Answer(*found.params, found.loglike, converged=word(found.optimizer_converged))


def kalmanbox_em(z):
    from kalmanbox import LocalLevel
    from kalmanbox.estimation.em import EMEstimator

    found = EMEstimator().fit(LocalLevel(z), z)
    return Answer(*found.params, found.loglike, converged=word(found.optimizer_converged))


def kalman_py(z, method="gradient"):
    """It asks for a start: N(0, ten times the mean of z²). With JAX installed "gradient" is its default."""
    from kalman_py.learning import fit_noise

    found = fit_noise([[1]], [[1]], z[:, None], [0], [[10 * np.mean(z**2)]], method=method)
    return Answer(found.R[0, 0], found.Q[0, 0], found.log_likelihood, found.n_iter, word(found.converged))


def kalman_py_em(z):
    """The default without JAX."""
    return kalman_py(z, method="em")


def pykalman(z):
    """Ten rounds of EM, in which it fits the start as well."""
    from pykalman import KalmanFilter

    kf = KalmanFilter().em(z)
    return Answer(kf.observation_covariance[0, 0], kf.transition_covariance[0, 0], kf.loglikelihood(z), 10)


def kalman_em(z):
    """EM of the readings divided by their standard deviation; F, H and the start are fitted as well."""
    from kalman_em import KalmanEM

    model = KalmanEM(d=1, verbose=False).fit(z)
    H, Q, R = (model.params_[name][0, 0] for name in "HQR")
    square = model._scaler[1][0] ** 2
    return Answer(R * square, H**2 * Q * square, steps=len(model.log_liks_))


def viking(z):
    """EM; it asks for a first Q and the number of rounds: 1 and 1000."""
    from viking_kalman import expectation_maximization

    found = expectation_maximization(np.ones((len(z), 1)), z, 1000, np.eye(1), verbose=0)
    return Answer(found["sig"].item() ** 2, found["Q"].item(), len(z) * found["loglik"][-1].item(), 1000)


def trosna(z):
    from trosna_kalman.estimation import estimate_noise_parameters

    found = estimate_noise_parameters(z)
    return Answer(found.r, found.q)


def dynamax(z):
    """Fifty rounds of EM (its default), in which everything is fitted: F, H, two constants and the start as well."""
    import jax
    from dynamax.linear_gaussian_ssm import LinearGaussianSSM

    model = LinearGaussianSSM(1, 1)
    first, properties = model.initialize(jax.random.PRNGKey(0))
    found, values = model.fit_em(first, properties, jax.numpy.array(z)[:, None], verbose=False)
    H, Q, R = found.emissions.weights[0, 0], found.dynamics.cov[0, 0], found.emissions.cov[0, 0]
    return Answer(float(R), float(H**2 * Q), float(values[-1]), 50)


class Library(NamedTuple):
    ask: object
    package: str
    call: str
    also: str = "-"  # what else it fits


LIBRARIES = {
    "statsmodels": Library(statsmodels, "statsmodels", "UnobservedComponents(z 'llevel').fit()"),
    "statsmodels exact": Library(statsmodels_exact, "statsmodels", "the same with use_exact_diffuse"),
    "R StructTS": Library(struct_ts, "R", "StructTS(z 'level')"),
    "ssfortran": Library(ssfortran, "ssfortran", "StructuralModel(z [Irregular() Level()]).fit()"),
    "kalmanbox": Library(kalmanbox, "kalmanbox", "LocalLevel(z).fit()"),
    "kalmanbox EM": Library(kalmanbox_em, "kalmanbox", "EMEstimator().fit(LocalLevel(z) z)"),
    "kalman-py EM": Library(kalman_py_em, "kalman-py", "fit_noise(method='em')"),
    "kalman-py JAX": Library(kalman_py, "kalman-py", "fit_noise() with JAX"),
    "trosna-kalman": Library(trosna, "trosna-kalman", "estimate_noise_parameters(z)"),
    "viking-kalman EM": Library(viking, "viking-kalman", "expectation_maximization(1000 rounds)", "start"),
    "pykalman EM": Library(pykalman, "pykalman", "KalmanFilter().em(z)", "start"),
    "kalman-em": Library(kalman_em, "kalman-em", "KalmanEM(d=1).fit(z)", "F H start"),
    "dynamax EM": Library(dynamax, "dynamax", "LinearGaussianSSM(1 1).fit_em()", "F H constants start"),
}


def asked(name, series):
    """The version and the answers of a library, one for each series; of one that raises, its kind of error."""
    library, answers = LIBRARIES[name], []
    for z in series:
        try:
            answers.append(library.ask(z))
        except Exception as reason:
            answers.append(Answer(np.nan, np.nan, converged=type(reason).__name__))
    return {"version": r_version() if library.package == "R" else version(library.package), "answers": answers}


def r_version():
    command = ["Rscript", "-e", "cat(format(getRversion()))"]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


# ---- the course's side


def environment():
    """The Python of the libraries; made anew when who_fits_nile.txt is another one."""
    python, made = FOLDER / ("Scripts/python.exe" if os.name == "nt" else "bin/python"), FOLDER / PINS.name
    if not made.exists() or made.read_bytes() != PINS.read_bytes():
        shutil.rmtree(FOLDER, ignore_errors=True)
        venv.create(FOLDER, with_pip=True)
        subprocess.run([python, "-m", "pip", "install", "--quiet", "-r", PINS], check=True)
        shutil.copy(PINS, made)
    return python


def three(nile):
    """The series that everybody gets."""
    return [nile, TIMES * nile, np.random.default_rng(3).normal(1000, 100, 100)]


def ours(series):
    """What `fit` says; "boundary" where it says that Q = 0 is at its boundary."""
    import kflearn

    answers = []
    for z in series:
        found = kflearn.fit(kflearn.random_walk, z, {"Q": 1.0, "R": 1.0})
        R, Q = (found.parameters[name] for name in "RQ")
        said = "boundary" if found.at_boundary["Q"] else word(found.converged)
        answers.append(Answer(float(R), float(Q), float(found.log_likelihood_of_all), converged=said))
    return {"version": kflearn.__version__, "answers": answers}


def theirs(python, name, series):
    """What `asked` returns, in a process of its own."""
    command, text = [python, __file__, name], json.dumps([z.tolist() for z in series])
    done = subprocess.run(command, input=text, capture_output=True, text=True, timeout=LIMIT, check=True)
    said = json.loads(done.stdout.splitlines()[-1])
    return said | {"answers": [Answer(*answer) for answer in said["answers"]]}


def row(name, call, also, said):
    """One row of the table; the variances of the series in another unit come back in the first one's."""
    one, other, white = said["answers"]
    cells = [name, said["version"], call, one.R, one.Q, one.log_likelihood, one.steps, one.converged]
    cells += [other.R / TIMES**2, other.Q / TIMES**2, other.converged, white.R, white.Q, white.converged]
    told = (f"{cell:.8g}" if isinstance(cell, float | int) else cell for cell in cells)
    return [*told, also, date.today().isoformat()]


COLUMNS = "library version call R Q log_likelihood steps converged R_1000 Q_1000 converged_1000 R_white Q_white"
COLUMNS = [*COLUMNS.split(), "converged_white", "also", "seen"]


def main():
    from kflearn import examples

    series, python = three(examples.load("nile")["flow"]), environment()
    rows = [row("kflearn", "fit(random_walk z start)", "-", ours(series))]
    for name, library in LIBRARIES.items():
        if library.package == "R" and not shutil.which("Rscript"):
            print("no Rscript here: R is left out")
            continue
        rows.append(row(name, library.call, library.also, theirs(python, name, series)))
        print(*rows[-1], sep=", ", flush=True)
    with TARGET.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([COLUMNS, *rows])


if __name__ == "__main__":
    if len(sys.argv) > 1:
        print(json.dumps(asked(sys.argv[1], [np.array(z) for z in json.load(sys.stdin)]), default=float))
    else:
        main()
