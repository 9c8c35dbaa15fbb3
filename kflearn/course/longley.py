"""[NIST] Longley's regression: sixteen years of the US economy, on which programs for least squares are tested.

J. W. Longley, "An appraisal of least squares programs for the electronic computer from the point of view of the user",
Journal of the American Statistical Association 62 (1967) 819. Data and certified coefficients: NIST, Statistical
Reference Datasets, https://www.itl.nist.gov/div898/strd/lls/data/Longley.shtml (public domain).

Examples
--------
>>> from kflearn.course import longley
>>> print(longley.H.shape, f"{longley.z[0]:.0f} thousand people had work in {longley.H[0, 6]:.0f}")
(16, 7) 60323 thousand people had work in 1947
"""

import numpy as np

from ..filters.square_root import square_root_kalman_filter, triangular
from ..models.gaussian import Gaussian
from ..models.state_space import LinearModel

# employed people (thousands); deflator of the gross national product, the product itself (million $), unemployed,
# armed forces (both in hundreds), population from 14 years on (thousands), year
_TABLE = """
60323  83.0 234289 2356 1590 107608 1947
61122  88.5 259426 2325 1456 108632 1948
60171  88.2 258054 3682 1616 109773 1949
61187  89.5 284599 3351 1650 110929 1950
63221  96.2 328975 2099 3099 112075 1951
63639  98.1 346999 1932 3594 113270 1952
64989  99.0 365385 1870 3547 115094 1953
63761 100.0 363112 3578 3350 116219 1954
66019 101.2 397469 2904 3048 117388 1955
67857 104.6 419180 2822 2857 118734 1956
68169 108.4 442769 2936 2798 120445 1957
66513 110.8 444546 4681 2637 121950 1958
68655 112.6 482704 3813 2552 123366 1959
69564 114.2 502601 3931 2514 125368 1960
69331 115.7 518173 4806 2572 127852 1961
70551 116.9 554894 4007 2827 130081 1962
"""
_NUMBERS = np.array(_TABLE.split(), float).reshape(16, 7)

z = _NUMBERS[:, 0]  # the readings, in thousands of people
H = np.concatenate([np.ones((16, 1)), _NUMBERS[:, 1:]], axis=1)  # one row a year; the first column is the constant
CERTIFIED = np.array(
    [
        -3482258.63459582,
        15.0618722713733,
        -0.358191792925910e-1,
        -2.02022980381683,
        -1.03322686717359,
        -0.511041056535807e-1,
        1829.15146461355,
    ]
)
for _array in (z, H, CERTIFIED):
    _array.flags.writeable = False

MODEL = LinearModel(np.eye(7), H[:, None], np.zeros((7, 7)), 1e5)  # the coefficients never change; R is about 300²


def digits(x) -> float:
    """How many digits of the worst of seven coefficients (7,) agree with the certified ones; at least 0."""
    return float(max(0, -np.log10(np.max(abs(x / CERTIFIED - 1)))))


def at_once(P0=None) -> np.ndarray:
    """The coefficients (7,) by NumPy's lstsq, from all years together; it needs no P₀."""
    return np.linalg.lstsq(H, z)[0]


def by_joseph(P0) -> np.ndarray:
    """The coefficients (7,) by a Kalman filter in Joseph's form, one year after another, from N(0, P₀ I)."""
    P, x, R = P0 * np.eye(7), np.zeros(7), MODEL.R[0, 0]
    for row, reading in zip(H, z, strict=True):
        K = P @ row / (row @ P @ row + R)
        keep = np.eye(7) - np.outer(K, row)
        x, P = x + K * (reading - row @ x), keep @ P @ keep.T + R * np.outer(K, K)
    return x


def by_root(P0) -> np.ndarray:
    """The coefficients (7,) by kflearn's square-root filter, from N(0, P₀ I)."""
    return square_root_kalman_filter(MODEL, z, Gaussian(np.zeros(7), P0 * np.eye(7))).mean[-1]


def by_root_noise_first(P0) -> np.ndarray:
    """The same with the columns of the array in the other order: [[R½, H L], [0, L]]."""
    L, x, r = P0**0.5 * np.eye(7), np.zeros(7), MODEL.R[0] ** 0.5
    for row, reading in zip(H, z, strict=True):
        array = np.vstack([np.append(r, row @ L), np.hstack([np.zeros((7, 1)), L])])
        array = triangular(array)
        x, L = x + array[1:, 0] / array[0, 0] * (reading - row @ x), array[1:, 1:]
    return x


WAYS = {"lstsq, at once": at_once, "Joseph": by_joseph, "root, R½ first": by_root_noise_first, "root, R½ last": by_root}
