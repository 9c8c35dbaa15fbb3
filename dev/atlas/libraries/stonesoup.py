"""Stone Soup

States and readings are columns with a time. A gap is a prediction without an update. `LinearGaussian` measures
components of the state, here the first ones; its H cannot be given as a matrix. It has no likelihood of a series.
"""

from datetime import datetime, timedelta

import numpy as np
from stonesoup.models.measurement.linear import LinearGaussian
from stonesoup.models.transition.linear import LinearGaussianTimeInvariantTransitionModel as Motion
from stonesoup.predictor.kalman import KalmanPredictor
from stonesoup.types.detection import Detection
from stonesoup.types.hypothesis import SingleHypothesis
from stonesoup.types.state import GaussianState
from stonesoup.updater.kalman import KalmanUpdater

PINS = "stonesoup==1.9.1 numpy==2.4.6 scipy==1.17.1"


def plain(F, H, Q, R, x, P, z):
    sensor = LinearGaussian(len(x), tuple(range(len(R))), R)
    predictor, updater = KalmanPredictor(Motion(transition_matrix=F, covariance_matrix=Q)), KalmanUpdater(sensor)
    belief, means, covs = GaussianState(x[:, None], P, timestamp=datetime(2026, 1, 1)), [], []
    for reading in z:
        belief = predictor.predict(belief, timestamp=belief.timestamp + timedelta(seconds=1))
        detection = Detection(reading[:, None], timestamp=belief.timestamp)
        belief = updater.update(SingleHypothesis(belief, detection))
        means, covs = [*means, np.ravel(belief.mean)], [*covs, belief.covar]
    return means, covs


def same(F, H, Q, R, x, P, z):
    sensor = LinearGaussian(len(x), tuple(range(len(R))), R)  # it measures the first components
    predictor, updater = KalmanPredictor(Motion(transition_matrix=F, covariance_matrix=Q)), KalmanUpdater(sensor)
    belief, means, covs = GaussianState(x[:, None], P, timestamp=datetime(2026, 1, 1)), [], []
    for reading in z:
        belief = predictor.predict(belief, timestamp=belief.timestamp + timedelta(seconds=1))
        if not np.isnan(reading).all():
            detection = Detection(reading[:, None], timestamp=belief.timestamp)
            belief = updater.update(SingleHypothesis(belief, detection))
        means, covs = [*means, np.ravel(belief.mean)], [*covs, belief.covar]
    return means, covs
