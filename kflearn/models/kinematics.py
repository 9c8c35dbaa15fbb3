"""Ready-made linear models: random walk, constant velocity and acceleration, Singer's manoeuvres, a cart.

Where dt is asked for, it is a number of seconds above 0, or one for each step, an array (..., T) of numbers that are 0
or more; then the model has a stack of matrices (..., T, n, n). See `continuous` for any other continuous model.
"""

import numpy as np

from . import checks as check
from .state_space import LinearModel


def random_walk(Q, R, dt=None) -> LinearModel:
    """A quantity that drifts, and is measured itself.

    Parameters
    ----------
    Q : float or array_like (n, n)
        Covariance of the drift of one step, in squared units; of one second, where dt is given. A number for n = 1.
    R : float or array_like (n, n)
        Covariance of the measurement noise, in squared units.
    dt : float or array_like (..., T), optional
        Seconds from one measurement to the next, one number or one for each step: then Q times dt is that of a step.

    Returns
    -------
    LinearModel
        With F = H = I.

    Raises
    ------
    ValueError or TypeError
        Naming the argument.

    Examples
    --------
    >>> from kflearn import random_walk
    >>> print(random_walk(Q=0.01, R=0.25))
    LinearModel with n = 1, m = 1, p = 0:
      F = 1, H = 1, Q = 0.01, R = 0.25
    """
    Q = check.covariance("Q", Q)
    identity = np.eye(Q.shape[-1])
    if dt is not None:
        Q = Q * check.time_steps("dt", dt)[..., None, None]
    return LinearModel(F=identity, H=identity, Q=Q, R=R)


def constant_velocity(dt, acceleration, R) -> LinearModel:
    """Position and velocity on a line; the position is measured.

    The unknown acceleration is constant during a step and new at each: Q = σ² Γ Γᵀ with Γ = [dt²/2, dt].

    Parameters
    ----------
    dt : float or array_like (..., T)
        Seconds from one measurement to the next: one number, or one for each step.
    acceleration : float
        σ, the standard deviation of the unknown acceleration, in m/s²; 0 or more.
    R : float
        Variance of the measured position, in m².

    Returns
    -------
    LinearModel
        State [position (m), velocity (m/s)].

    Raises
    ------
    ValueError or TypeError
        Naming the argument.

    References
    ----------
    Bar-Shalom, Li and Kirubarajan 2001, eq. (6.3.2-4).

    Examples
    --------
    >>> from kflearn import constant_velocity
    >>> print(constant_velocity(dt=2, acceleration=0.5, R=9).Q)
    [[1. 1.]
     [1. 1.]]
    """
    push, sigma = _kick(dt), check.number("acceleration", acceleration, least=0)
    return LinearModel(F=_drift(dt), H=[[1, 0]], Q=sigma**2 * push @ push.mT, R=R)


def white_acceleration(dt, intensity, R) -> LinearModel:
    """Position and velocity on a line, pushed by white acceleration, new at every instant; the position is measured.

    Q = q [[dt³/3, dt²/2], [dt²/2, dt]]: two short steps make the same as one long step, so this is the Q for steps of
    different lengths.

    Parameters
    ----------
    dt : float or array_like (..., T)
        Seconds from one measurement to the next: one number, or one for each step.
    intensity : float
        q, by how much the variance of the velocity grows in a second, in m²/s³; 0 or more.
    R : float
        Variance of the measured position, in m².

    Returns
    -------
    LinearModel
        State [position (m), velocity (m/s)].

    Raises
    ------
    ValueError or TypeError
        Naming the argument.

    References
    ----------
    Bar-Shalom, Li and Kirubarajan 2001, eq. (6.2.2-12).

    Examples
    --------
    >>> from kflearn import white_acceleration
    >>> print(white_acceleration(dt=[0, 3], intensity=1, R=9).Q[1])
    [[9.  4.5]
     [4.5 3. ]]
    """
    F, q = _drift(dt), check.number("intensity", intensity, least=0)
    dt = F[..., 0, 1]
    return LinearModel(F, H=[[1, 0]], Q=q * matrices([[dt**3 / 3, dt**2 / 2], [dt**2 / 2, dt]]), R=R)


def constant_acceleration(dt, acceleration_increment, R) -> LinearModel:
    """Position, velocity and acceleration on a line; the position is measured.

    At each step an unknown increment is added to the acceleration: Q = σ² Γ Γᵀ with Γ = [dt²/2, dt, 1].

    Parameters
    ----------
    dt : float or array_like (..., T)
        Seconds from one measurement to the next: one number, or one for each step.
    acceleration_increment : float
        σ, the standard deviation of what is added to the acceleration at each step, in m/s²; 0 or more. (It is no jerk:
        a jerk, in m/s³, times dt gives such an increment.)
    R : float
        Variance of the measured position, in m².

    Returns
    -------
    LinearModel
        State [position (m), velocity (m/s), acceleration (m/s²)].

    Raises
    ------
    ValueError or TypeError
        Naming the argument.

    References
    ----------
    Bar-Shalom, Li and Kirubarajan 2001, eq. (6.3.3-3).

    Examples
    --------
    >>> from kflearn import constant_acceleration
    >>> print(constant_acceleration(dt=1, acceleration_increment=2, R=9).Q)
    [[1. 2. 2.]
     [2. 4. 4.]
     [2. 4. 4.]]
    """
    dt = check.time_steps("dt", dt)
    sigma = check.number("acceleration_increment", acceleration_increment, least=0)
    push = matrices([[dt**2 / 2], [dt], [dt > 0]])  # in no time nothing is added
    F = matrices([[1, dt, dt**2 / 2], [0, 1, dt], [0, 0, 1]])
    return LinearModel(F, [[1, 0, 0]], sigma**2 * push @ push.mT, R)


def singer(dt, rate, acceleration, R) -> LinearModel:
    """A target that manoeuvres: as constant_acceleration, but the acceleration fades and is renewed by noise.

    Q = 2 rate σ² ∫ g gᵀ from 0 to dt, where g(t) is the last column of F(t).

    Parameters
    ----------
    dt : float or array_like (..., T)
        Seconds from one measurement to the next: one number, or one for each step.
    rate : float
        How fast the acceleration fades, in 1/s; a manoeuvre lasts about 1/rate seconds.
    acceleration : float
        σ, the standard deviation of the acceleration in the long run, in m/s²; 0 or more.
    R : float
        Variance of the measured position, in m².

    Returns
    -------
    LinearModel
        State [position (m), velocity (m/s), acceleration (m/s²)].

    Raises
    ------
    ValueError or TypeError
        Naming the argument.

    References
    ----------
    Singer 1970, IEEE Transactions on Aerospace and Electronic Systems 6, 473–483.

    Examples
    --------
    >>> from kflearn import singer
    >>> model = singer(dt=1, rate=0.1, acceleration=2, R=9)
    >>> print(f"{model.F[2, 2]:.3f} {model.Q[2, 2]:.3f}")
    0.905 0.725
    """
    F = singer_matrix(dt, rate)
    sigma, dt = check.number("acceleration", acceleration, least=0), F[..., 0, 1]
    # Gauss–Legendre quadrature: the closed form subtracts nearly equal numbers when rate·dt is small.
    nodes, weights = np.polynomial.legendre.leggauss(64)
    g = np.stack([singer_matrix(dt * (1 + node) / 2, rate)[..., 2] for node in nodes], axis=-1)
    Q = 2 * rate * sigma**2 * (dt[..., None, None] / 2 * weights * g) @ g.mT
    return LinearModel(F, [[1, 0, 0]], (Q + Q.mT) / 2, R)


def singer_matrix(dt, rate) -> np.ndarray:
    """F (3, 3) of position, velocity and an acceleration that fades with `rate` (1/s) over dt seconds."""
    dt, rate = check.time_steps("dt", dt), check.number("rate", rate, positive=True)
    fading = -np.expm1(-rate * dt)
    return matrices([[1, dt, (rate * dt - fading) / rate**2], [0, 1, fading / rate], [0, 0, np.exp(-rate * dt)]])


def cart(dt, mass, Q, R) -> LinearModel:
    """Newton's cart, eqs (1)–(4): position and velocity on a line, pushed by a force; the position is measured.

    p_k = p + v dt + F/(2m) dt², v_k = v + F/m dt.

    Parameters
    ----------
    dt : float or array_like (..., T)
        Seconds from one measurement to the next: one number, or one for each step.
    mass : float
        In kg.
    Q : array_like (2, 2)
        Covariance of what disturbs a step.
    R : float
        Variance of the measured position, in m².

    Returns
    -------
    LinearModel
        State [position (m), velocity (m/s)], control input the force (N).

    Raises
    ------
    ValueError or TypeError
        Naming the argument.

    Examples
    --------
    >>> import numpy as np
    >>> from kflearn import cart
    >>> model = cart(dt=2, mass=4, Q=np.zeros((2, 2)), R=1)
    >>> print(model.move(np.array([5.0, 3.0]), np.array([8.0])))  # pushed with 8 N for 2 s
    [15.  7.]
    """
    push = _kick(dt) / check.number("mass", mass, positive=True)
    return LinearModel(F=_drift(dt), H=[[1, 0]], Q=Q, R=R, B=push)


def _drift(dt):
    """How position and velocity go on by themselves in dt seconds, (..., 2, 2)."""
    return matrices([[1, check.time_steps("dt", dt)], [0, 1]])


def _kick(dt):
    """What one unit of constant acceleration does to [position, velocity] in dt seconds, (..., 2, 1)."""
    dt = check.time_steps("dt", dt)
    return matrices([[dt**2 / 2], [dt]])


def matrices(rows) -> np.ndarray:
    """Rows of entries, each a number or an array (..., T), as one matrix or a stack of matrices (..., T, n, m)."""
    entries = np.broadcast_arrays(*(entry for row in rows for entry in row))
    return np.stack(entries, axis=-1).astype(float).reshape(*entries[0].shape, len(rows), len(rows[0]))
