"""OpenCV

Columns: x is (n, 1), z is (m, 1). Ask for CV_64F, else it computes in single precision. A gap: predict() alone; the
belief is then in `statePre` and `errorCovPre`, and predict() copies it to `statePost`. There is no likelihood.
"""

import cv2
import numpy as np

PINS = "opencv-python-headless==5.0.0.93 numpy==2.4.6"


def plain(F, H, Q, R, x, P, z):
    kf = cv2.KalmanFilter(len(x), len(R), 0, cv2.CV_64F)
    kf.transitionMatrix, kf.measurementMatrix, kf.processNoiseCov, kf.measurementNoiseCov = F, H, Q, R
    kf.statePost, kf.errorCovPost = x[:, None], P
    means, covs = [], []
    for reading in z:
        kf.predict()
        means.append(kf.correct(reading[:, None])[:, 0].copy())
        covs.append(kf.errorCovPost.copy())
    return means, covs


def same(F, H, Q, R, x, P, z):
    kf = cv2.KalmanFilter(len(x), len(R), 0, cv2.CV_64F)
    kf.transitionMatrix, kf.measurementMatrix, kf.processNoiseCov, kf.measurementNoiseCov = F, H, Q, R
    kf.statePost, kf.errorCovPost = x[:, None], P
    means, covs = [], []
    for reading in z:
        kf.predict()
        if not np.isnan(reading).all():
            kf.correct(reading[:, None])
        means.append(kf.statePost[:, 0].copy())
        covs.append(kf.errorCovPost.copy())
    return means, covs
