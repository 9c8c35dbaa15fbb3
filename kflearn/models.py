"""State-space models: how the state moves, how it is measured, and how uncertain both are."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from . import _checks as check


@dataclass(frozen=True, eq=False)
class LinearModel:
    """x_k = F x_{k-1} + B u_k + w,  z_k = H x_k + v,  with w ~ N(0, Q) and v ~ N(0, R): eqs (3) and (4).

    F (n, n), H (m, n), Q (n, n), R (m, m), B (n, p) or None. Each may also be a stack (..., T, n, n), one matrix a
    step (T may be 1), whose leading axes are batch axes. Plain numbers stand for (1, 1) matrices. Units: Q those of
    the state squared, R those of the measurement squared, both per step.

    Raises ValueError or TypeError, naming the matrix, when a shape does not fit, Q is not a covariance or R is not
    positive definite.
    """

    F: np.ndarray
    H: np.ndarray
    Q: np.ndarray
    R: np.ndarray
    B: np.ndarray | None = None

    def __post_init__(self):
        F = check.square("F", self.F)
        n = F.shape[-1]
        H = check.matrix("H", self.H, None, n)
        m = H.shape[-2]
        Q = check.covariance("Q", self.Q, n)
        R = check.covariance("R", self.R, m, definite=True)
        B = None if self.B is None else check.matrix("B", self.B, n, None)
        for name, value in zip("FHQRB", (F, H, Q, R, B), strict=True):
            object.__setattr__(self, name, value)

    @property
    def n(self):
        """The number of states."""
        return self.F.shape[-1]

    @property
    def m(self):
        """The number of measured components."""
        return self.H.shape[-2]

    @property
    def p(self):
        """The number of control inputs."""
        return 0 if self.B is None else self.B.shape[-1]

    def replace(self, **changes):
        """The same model with some matrices changed, e.g. model.replace(R=4)."""
        return replace(self, **changes)

    def move(self, x, u=None, k=0):
        """F x + B u at step k, for states x (..., n)."""
        moved = apply(at(self.F, k), x)
        return moved if u is None else moved + apply(at(self.B, k), u)

    def measure(self, x, k=0):
        """H x at step k, for states x (..., n)."""
        return apply(at(self.H, k), x)

    def move_slope(self, x, u=None, k=0):
        """F at step k, whatever x is."""
        return at(self.F, k)

    def measure_slope(self, x, k=0):
        """H at step k, whatever x is."""
        return at(self.H, k)

    def difference(self, z, expected):
        """z − expected."""
        return z - expected


@dataclass(frozen=True, eq=False)
class NonlinearModel:
    """x_k = f(x_{k-1}) + w or f(x_{k-1}, u_k) + w,  z_k = h(x_k) + v,  with w ~ N(0, Q) and v ~ N(0, R).

    f: (..., n) → (..., n), called with u as its second argument when a control input is given; h: (..., n) → (..., m).
    Q (n, n), R (m, m), or stacks (..., T, n, n). F_jacobian(x) or F_jacobian(x, u): (..., n, n) and H_jacobian(x):
    (..., m, n); without them central differences are taken, whose steps fit states of the size `scale`, a number or
    (n,), and larger ones: set it where a state in its unit is far below 1. residual(z, expected): the difference of
    two measurements, for quantities such as angles that wrap; default z − expected.
    """

    f: Callable
    h: Callable
    Q: np.ndarray
    R: np.ndarray
    F_jacobian: Callable | None = None
    H_jacobian: Callable | None = None
    residual: Callable | None = None
    scale: np.ndarray = 1.0

    def __post_init__(self):
        for name in ("f", "h"):
            if not callable(getattr(self, name)):
                raise TypeError(f"{name} must be a function, got {type(getattr(self, name)).__name__}")
        for name in ("F_jacobian", "H_jacobian", "residual"):
            check.callable_or_none(name, getattr(self, name))
        object.__setattr__(self, "Q", check.covariance("Q", self.Q))
        object.__setattr__(self, "R", check.covariance("R", self.R, definite=True))
        object.__setattr__(self, "scale", check.sizes("scale", self.scale, self.n))

    @property
    def n(self):
        """The number of states."""
        return self.Q.shape[-1]

    @property
    def m(self):
        """The number of measured components."""
        return self.R.shape[-1]

    def replace(self, **changes):
        """The same model with some parts changed, e.g. model.replace(R=4)."""
        return replace(self, **changes)

    def move(self, x, u=None, k=0):
        """f(x) or f(x, u), for states x (..., n)."""
        return self.f(x) if u is None else self.f(x, u)

    def measure(self, x, k=0):
        """h(x), for states x (..., n)."""
        return self.h(x)

    def move_slope(self, x, u=None, k=0):
        """The Jacobian of f at x (..., n): (..., n, n)."""
        if self.F_jacobian is None:
            return numerical_jacobian(lambda points: self.move(points, u), x, scale=self.scale)
        return self.F_jacobian(x) if u is None else self.F_jacobian(x, u)

    def measure_slope(self, x, k=0):
        """The Jacobian of h at x (..., n): (..., m, n)."""
        if self.H_jacobian is not None:
            return self.H_jacobian(x)
        return numerical_jacobian(self.h, x, self.difference, self.scale)

    def difference(self, z, expected):
        """residual(z, expected), or z − expected where no residual was given."""
        return z - expected if self.residual is None else self.residual(z, expected)


def at(matrix, k):
    """The matrix of step k: `matrix` itself, or its k-th slice where it is a stack (..., T, rows, columns)."""
    if matrix.ndim == 2:
        return matrix
    return matrix[..., k if matrix.shape[-3] > 1 else 0, :, :]


def apply(matrix, x):
    """The products of a matrix, or of one matrix each, with the vectors x (..., n)."""
    return x @ matrix.T if matrix.ndim == 2 else np.matvec(matrix, x)


def stacks(model):
    """{name: matrix} of the model's matrices that come as a stack (..., T, rows, columns)."""
    matrices = {name: getattr(model, name, None) for name in "FHBQR"}
    return {name: M for name, M in matrices.items() if M is not None and M.ndim > 2}


def numerical_jacobian(function, x, difference=np.subtract, scale=1.0):
    """The Jacobian (..., m, n) of `function` at x (..., n) by central differences with 5 to 10 correct digits.

    That holds where the components of x are of the order of `scale`, a number or (n,), or larger: the step is
    6e-6 max(|x|, scale). `function` gets states with one more axis in front, (n, ..., n). `difference(a, b)` subtracts
    two of its values; give the model's own for angles. Raises ValueError where `scale` does not fit or is not positive.
    """
    x = np.asarray(x, dtype=float)
    step = np.cbrt(np.finfo(float).eps) * np.maximum(abs(x), check.sizes("scale", scale, x.shape[-1]))
    shift = np.moveaxis(step[..., None, :] * np.eye(x.shape[-1]), -2, 0)
    return np.moveaxis(difference(function(x + shift), function(x - shift)), 0, -1) / (2 * step[..., None, :])


def random_walk(Q, R):
    """A quantity that drifts by N(0, Q) a step and is measured with noise N(0, R); Q and R (n, n) or numbers."""
    Q = check.covariance("Q", Q)
    identity = np.eye(Q.shape[-1])
    return LinearModel(F=identity, H=identity, Q=Q, R=R)


def constant_velocity(dt, acceleration, R):
    """Position (m) and velocity (m/s) on a line; the position is measured with variance R (m²) every dt seconds.

    `acceleration` (m/s²) is the standard deviation of the unknown acceleration, constant during a step, new at each:
    Q = σ² Γ Γᵀ with Γ = [dt²/2, dt] (Bar-Shalom, Li and Kirubarajan 2001, eq. 6.3.2-4).
    """
    push, sigma = _kick(dt), check.number("acceleration", acceleration)
    return LinearModel(F=[[1, dt], [0, 1]], H=[[1, 0]], Q=sigma**2 * push @ push.T, R=R)


def constant_acceleration(dt, jerk, R):
    """Position, velocity and acceleration on a line (m, s); the position is measured with variance R (m²).

    `jerk` (m/s²) is the standard deviation of what is added to the acceleration at each step of dt seconds:
    Q = σ² Γ Γᵀ with Γ = [dt²/2, dt, 1] (Bar-Shalom, Li and Kirubarajan 2001, eq. 6.3.3-3).
    """
    dt, sigma = check.number("dt", dt, positive=True), check.number("jerk", jerk)
    push = np.array([[dt**2 / 2], [dt], [1]])
    return LinearModel([[1, dt, dt**2 / 2], [0, 1, dt], [0, 0, 1]], [[1, 0, 0]], sigma**2 * push @ push.T, R)


def singer(dt, rate, acceleration, R):
    """As constant_acceleration, but the acceleration fades with `rate` (1/s) and is renewed by noise: a manoeuvre of
    standard deviation `acceleration` (m/s²) that lasts about 1/rate seconds.

    Q = 2 rate σ² ∫ g gᵀ from 0 to dt, g(t) the last column of F(t) (Singer 1970).
    """
    F = singer_matrix(dt, rate)
    # Gauss–Legendre quadrature: the closed form subtracts nearly equal numbers when rate·dt is small.
    nodes, weights = np.polynomial.legendre.leggauss(64)
    g = np.stack([singer_matrix(dt * (1 + node) / 2, rate)[:, 2] for node in nodes], axis=-1)
    Q = 2 * rate * check.number("acceleration", acceleration) ** 2 * (dt / 2 * weights * g) @ g.T
    return LinearModel(F, [[1, 0, 0]], (Q + Q.T) / 2, R)


def singer_matrix(dt, rate):
    """F (3, 3) of position, velocity and an acceleration that fades with `rate` (1/s) over dt seconds."""
    dt, rate = check.number("dt", dt, positive=True), check.number("rate", rate, positive=True)
    fading = -np.expm1(-rate * dt)
    return np.array([[1, dt, (rate * dt - fading) / rate**2], [0, 1, fading / rate], [0, 0, np.exp(-rate * dt)]])


def cart(dt, mass, Q, R):
    """Newton's cart: state [position (m), velocity (m/s)], control input the force (N), eqs (1)–(4).

    s_k = s + v dt + F/(2m) dt², v_k = v + F/m dt. Q (2, 2) is the covariance of what disturbs a step, R (m²) the
    variance of the measured position.
    """
    push = _kick(dt) / check.number("mass", mass, positive=True)
    return LinearModel(F=[[1, dt], [0, 1]], H=[[1, 0]], Q=Q, R=R, B=push)


def _kick(dt):
    """What one unit of constant acceleration does to [position, velocity] in dt seconds, (2, 1)."""
    dt = check.number("dt", dt, positive=True)
    return np.array([[dt**2 / 2], [dt]])
