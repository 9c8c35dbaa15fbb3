"""kflearn: Kalman filters written to be read, the package behind the course.

A belief is a Gaussian with a mean (..., n) and a covariance (..., n, n). A model says how a state moves and how it is
measured: LinearModel or NonlinearModel. A filter takes a model, measurements (..., T, m) and an initial belief, and
returns a track: the beliefs after each measurement. Everything broadcasts over leading axes: a thousand runs are one
call.

    >>> from kflearn import Gaussian, kalman_filter, random_walk
    >>> track = kalman_filter(random_walk(0, 1), [1.0, 2.0, 3.0], Gaussian(0, 1e6))
    >>> print(f"{track.mean[-1, 0]:.2f} ± {track.std[-1, 0]:.2f}")
    2.00 ± 0.58

The filters, called as filter(model, z, initial, u); FILTERS holds the same table as data:

    filter                      models               returns             rts_smoother
    kalman_filter               linear               Track               yes
    square_root_kalman_filter   linear               Track               yes
    schmidt_kalman_filter       linear               Track               no
    extended_kalman_filter      linear, nonlinear    Track               yes
    unscented_kalman_filter     linear, nonlinear    Track               yes
    cubature_kalman_filter      linear, nonlinear    Track               yes
    linearized_kalman_filter    linear, nonlinear    Track               yes
    adaptive_kalman_filter      linear, nonlinear    AdaptiveTrack       no
    imm_filter                  several, of both     MultipleModelTrack  no
    mmae_filter                 several, of both     MultipleModelTrack  no

Step by step: predict, correct, kalman_step; OnlineFilter, for readings as they come. Time: discretise, for steps of
any length; Readings, merge_events, several sensors; TimedFilter, late readings. Starts: start_from, diffuse_start;
from_first_reading and to_first_reading, for libraries whose start is at the first reading. The ways through a
function: linearize, unscented, cubature. Smoothers: rts_smoother, two_filter_smoother, lag_one_covariances; what comes
next: forecast, steady_state. Parameters from data: fit, em; disturbances, which reading was odd. Is the filter honest?
nees, nis, coverage, whiteness, chi_square_interval, rmse, report_card; running_nis, cusum, while it runs;
cramer_rao_bound, could any do better? with_error, a Measured mean over runs. Models: random_walk, constant_velocity,
white_acceleration, constant_acceleration, singer, cart; simulate, numerical_jacobian. Whose reading is it?
scan_targets, pair_up, pda_weights, assign; pda_filter, nearest_filter and gnn_filter, which return a ScanTrack;
tracker, gospa. Angles: wrap, angle_difference, circular_mean. Of the course: scenarios, recordings (which raises
RecordingError), examples (real recordings), bearings, boats, homing, navigation, video, plots.
"""

from importlib import import_module

from .core.angles import angle_difference, circular_mean, wrap
from .course import bearings, boats, examples, homing, navigation, recordings, scenarios, video
from .course.recordings import RecordingError
from .filters.adaptive import AdaptiveTrack, adaptive_kalman_filter
from .filters.bound import cramer_rao_bound
from .filters.consider import schmidt_kalman_filter
from .filters.diffuse import diffuse_start
from .filters.disturbances import disturbances
from .filters.events import Readings, merge_events
from .filters.first_reading import from_first_reading, to_first_reading
from .filters.forecast import forecast
from .filters.kalman import (
    cubature_kalman_filter,
    extended_kalman_filter,
    kalman_filter,
    linearized_kalman_filter,
    unscented_kalman_filter,
)
from .filters.late import TimedFilter
from .filters.moments import cubature, linearize, unscented
from .filters.multiple_models import MultipleModelTrack, imm_filter, mmae_filter
from .filters.online import OnlineFilter
from .filters.smoothing import lag_one_covariances, rts_smoother
from .filters.square_root import square_root_kalman_filter
from .filters.start import start_from
from .filters.steady import steady_state
from .filters.steps import correct, kalman_step, predict
from .filters.table import Row, settings
from .filters.two_filter import two_filter_smoother
from .fitting.em import em
from .fitting.fit import fit
from .models.continuous import discretise
from .models.gaussian import Gaussian
from .models.kinematics import (
    cart,
    constant_acceleration,
    constant_velocity,
    random_walk,
    singer,
    white_acceleration,
)
from .models.simulation import simulate
from .models.slopes import numerical_jacobian
from .models.state_space import LinearModel, NonlinearModel
from .results.comparison import Measured, with_error
from .results.consistency import chi_square_interval, coverage, nees, nis, rmse, whiteness
from .results.report import report_card
from .results.track import Track
from .results.watch import cusum, running_nis
from .targets.assign import assign
from .targets.filters import ScanTrack, gnn_filter, nearest_filter, pda_filter, pda_weights
from .targets.gospa import gospa
from .targets.pairs import pair_up
from .targets.scans import scan_targets
from .targets.tracker import tracker

__version__ = "0.2.0"  # said here only: pyproject.toml, lesson 0 and the web page read it

# A new filter is a function in `filters`, and here its import, its name below, and its row; the tests do the rest.
FILTERS = (
    Row(kalman_filter, "linear", optional=settings(gate=0.5)),
    Row(square_root_kalman_filter, "linear", optional=settings(gate=0.5)),
    Row(schmidt_kalman_filter, "linear", smoothed=False, optional=settings(considered=[1], gate=0.5)),
    Row(extended_kalman_filter, "both", optional=settings(gate=0.5)),
    Row(unscented_kalman_filter, "both", optional=settings(alpha=0.5, beta=1.0, kappa=0.5, gate=0.5)),
    Row(cubature_kalman_filter, "both", optional=settings(gate=0.5)),
    Row(linearized_kalman_filter, "both", optional=settings(gate=0.5)),
    Row(
        adaptive_kalman_filter,
        "both",
        AdaptiveTrack,
        smoothed=False,
        optional=settings(window=5, floor=0.1, adapt="Q"),
        exact=False,
    ),
    Row(
        imm_filter,
        "both",
        MultipleModelTrack,
        smoothed=False,
        several=True,
        needed=settings(transition=[[0.9, 0.1], [0.2, 0.8]]),
        optional=settings(mode_probabilities=[0.4, 0.6]),
    ),
    Row(
        mmae_filter,
        "both",
        MultipleModelTrack,
        smoothed=False,
        several=True,
        optional=settings(mode_probabilities=[0.4, 0.6]),
    ),
)

__all__ = [
    "FILTERS",
    "Gaussian",
    "LinearModel",
    "Measured",
    "NonlinearModel",
    "OnlineFilter",
    "Readings",
    "RecordingError",
    "ScanTrack",
    "TimedFilter",
    "Track",
    "adaptive_kalman_filter",
    "angle_difference",
    "assign",
    "bearings",
    "boats",
    "cart",
    "chi_square_interval",
    "circular_mean",
    "constant_acceleration",
    "constant_velocity",
    "correct",
    "coverage",
    "cramer_rao_bound",
    "cubature",
    "cubature_kalman_filter",
    "cusum",
    "diffuse_start",
    "discretise",
    "disturbances",
    "em",
    "examples",
    "extended_kalman_filter",
    "fit",
    "forecast",
    "from_first_reading",
    "gnn_filter",
    "gospa",
    "homing",
    "imm_filter",
    "kalman_filter",
    "kalman_step",
    "lag_one_covariances",
    "linearize",
    "linearized_kalman_filter",
    "merge_events",
    "mmae_filter",
    "navigation",
    "nearest_filter",
    "nees",
    "nis",
    "numerical_jacobian",
    "pair_up",
    "pda_filter",
    "pda_weights",
    "plots",
    "predict",
    "random_walk",
    "recordings",
    "report_card",
    "rmse",
    "rts_smoother",
    "running_nis",
    "scan_targets",
    "scenarios",
    "schmidt_kalman_filter",
    "simulate",
    "singer",
    "square_root_kalman_filter",
    "start_from",
    "steady_state",
    "to_first_reading",
    "tracker",
    "two_filter_smoother",
    "unscented",
    "unscented_kalman_filter",
    "video",
    "white_acceleration",
    "whiteness",
    "with_error",
    "wrap",
]


def __dir__():
    return __all__


def __getattr__(name):
    """`plots` is loaded when it is first asked for: without it, kflearn needs no matplotlib."""
    if name == "plots":
        return import_module(".ui.plots", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
