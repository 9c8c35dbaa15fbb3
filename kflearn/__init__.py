"""kflearn: Kalman filters written to be read, the package behind the course.

Beliefs are Gaussians with a mean (..., n) and a covariance (..., n, n); models say how a state moves and is measured;
filters take a model, measurements (..., T, m) and an initial belief and return a Track. Everything broadcasts over
leading axes: a thousand runs are one call.
"""

from . import homing, navigation, recordings, scenarios, video
from .adaptive import adaptive_kalman_filter
from .angles import angle_difference, circular_mean, wrap
from .consider import schmidt_kalman_filter
from .consistency import chi_square_interval, coverage, nees, nis, rmse, whiteness
from .filtering import (
    correct,
    cubature_kalman_filter,
    extended_kalman_filter,
    kalman_filter,
    kalman_step,
    linearized_kalman_filter,
    predict,
    start_from,
    unscented_kalman_filter,
)
from .gaussian import Gaussian
from .models import (
    LinearModel,
    NonlinearModel,
    cart,
    constant_acceleration,
    constant_velocity,
    numerical_jacobian,
    random_walk,
    singer,
)
from .multiple_models import imm_filter, mmae_filter
from .report import report_card
from .simulation import simulate
from .smoothing import rts_smoother, two_filter_smoother
from .square_root import square_root_kalman_filter

__version__ = "0.1.1"  # said here only: pyproject.toml, lesson 0 and the web page read it

__all__ = [
    "Gaussian",
    "LinearModel",
    "NonlinearModel",
    "adaptive_kalman_filter",
    "angle_difference",
    "cart",
    "chi_square_interval",
    "circular_mean",
    "constant_acceleration",
    "constant_velocity",
    "correct",
    "coverage",
    "cubature_kalman_filter",
    "extended_kalman_filter",
    "homing",
    "imm_filter",
    "kalman_filter",
    "kalman_step",
    "linearized_kalman_filter",
    "mmae_filter",
    "navigation",
    "nees",
    "nis",
    "numerical_jacobian",
    "predict",
    "random_walk",
    "recordings",
    "report_card",
    "rmse",
    "rts_smoother",
    "scenarios",
    "schmidt_kalman_filter",
    "simulate",
    "singer",
    "square_root_kalman_filter",
    "start_from",
    "two_filter_smoother",
    "unscented_kalman_filter",
    "video",
    "whiteness",
    "wrap",
]
