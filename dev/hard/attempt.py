"""Run a filter as its severest user would: a warning is an error, and an error has to be a sentence."""

import warnings

import numpy as np

from kflearn import Gaussian
from kflearn.models.gaussian import unchecked_gaussian


def attempt(run, *arguments):
    """What a filter returns, all of it worked out, or the exception or warning that it makes."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            result = run(*arguments)
            beliefs(result)
            return result
        except Exception as error:
            return error


def beliefs(result):
    """Every Gaussian that a filter or a smoother returned, the most important one first."""
    if isinstance(result, Gaussian):
        return [result]
    if not np.isfinite(result.log_likelihood).all():
        raise FloatingPointError("log_likelihood is not finite")
    if hasattr(result, "modes"):
        means, covs = np.moveaxis(result.modes.mean, -2, 0), np.moveaxis(result.modes.cov, -3, 0)
        return [result.filtered, *map(unchecked_gaussian, means, covs)]
    return [result.filtered, result.predicted]


def refusal(error):
    """Is it a clear refusal: a sentence about what must be otherwise?"""
    return isinstance(error, (ValueError, TypeError)) and " must " in str(error)
