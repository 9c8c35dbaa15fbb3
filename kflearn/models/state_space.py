"""State-space models: how the state moves, how it is measured, and how uncertain both are."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from ..core.frozen import Frozen
from ..core.matrices import matvec, step_matrix
from . import checks as check
from .jumps import watched
from .signatures import takes
from .slopes import central_differences
from .words import in_words, name_of


@dataclass(frozen=True, eq=False, repr=False)
class LinearModel(Frozen):
    """A linear model with Gaussian noise, eqs (3) and (4).

    x_k = F x_{k-1} + B u_k + w,  z_k = H x_k + v,  with the process noise w ~ N(0, Q) and the measurement noise
    v ~ N(0, R).

    Parameters
    ----------
    F : array_like (n, n)
        How the state moves in one step.
    H : array_like (m, n)
        How the state is measured.
    Q : array_like (n, n)
        Covariance of the process noise of one step, in the squared units of the state.
    R : array_like (m, m)
        Covariance of the measurement noise, in the squared units of the measurement; positive definite.
    B : array_like (n, p), optional
        How the control input pushes the state.

    Each of them may also be a stack (..., T, rows, columns), one matrix for each step (T may be 1); the leading axes
    are batch axes. A plain number stands for a (1, 1) matrix. The arrays are copied and read-only.

    Raises
    ------
    ValueError or TypeError
        Naming the matrix, when a shape does not fit, Q is not a covariance, or R is not positive definite.

    References
    ----------
    Bar-Shalom, Li and Kirubarajan 2001, ch. 5.2.

    Examples
    --------
    >>> import numpy as np
    >>> from kflearn import LinearModel
    >>> model = LinearModel(F=[[1, 0.1], [0, 1]], H=[[1, 0]], Q=0.01 * np.eye(2), R=4)
    >>> print(model.n, model.m, model.p)
    2 1 0
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
    def n(self) -> int:
        """The number of states."""
        return self.F.shape[-1]

    @property
    def m(self) -> int:
        """The number of measured components."""
        return self.H.shape[-2]

    @property
    def p(self) -> int:
        """The number of control inputs; 0 without B."""
        return 0 if self.B is None else self.B.shape[-1]

    def replace(self, **changes) -> "LinearModel":
        """The same model with some matrices changed, e.g. model.replace(R=4)."""
        return replace(self, **changes)

    def move(self, x, u=None, k=0) -> np.ndarray:
        """F x + B u at step k, for states x (..., n) and inputs u (..., p). Raises ValueError for u without B."""
        moved = matvec(step_matrix(self.F, k), x)
        if u is None:
            return moved
        if self.B is None:
            raise ValueError(NO_B)
        return moved + matvec(step_matrix(self.B, k), np.atleast_1d(u))

    def measure(self, x, u=None, k=0) -> np.ndarray:
        """H x at step k, for states x (..., n), whatever u is."""
        return matvec(step_matrix(self.H, k), x)

    def move_slope(self, x, u=None, k=0) -> np.ndarray:
        """F at step k, whatever x is."""
        return step_matrix(self.F, k)

    def measure_slope(self, x, u=None, k=0) -> np.ndarray:
        """H at step k, whatever x and u are."""
        return step_matrix(self.H, k)

    def difference(self, z, expected) -> np.ndarray:
        """z − expected."""
        return z - expected

    def state_difference(self, x, other) -> np.ndarray:
        """x − other."""
        return x - other

    def __repr__(self):
        matrices = {name: getattr(self, name) for name in "FHBQR" if getattr(self, name) is not None}
        told = ", ".join(f"{name} = {in_words(M)}" for name, M in matrices.items())
        return f"LinearModel with n = {self.n}, m = {self.m}, p = {self.p}:\n  {told}"


NO_B = "u was given, but the model has no B: expected a model with B or no u"


@dataclass(frozen=True, eq=False, repr=False)
class NonlinearModel(Frozen):
    """A nonlinear model with Gaussian noise that is added.

    x_k = f(x_{k-1}, u_k, k) + w,  z_k = h(x_k, u_k, k) + v,  with the process noise w ~ N(0, Q) and the measurement
    noise v ~ N(0, R). Each function takes x, or x and u, or x, u and k: what it has parameters for. A sensor that moves
    is h(x, u), with its path in u.

    Every function works on the last axis and leaves all leading axes alone: called with one state (n,) it returns what
    belongs to this state, called with a batch (..., n) it returns the same for each state of the batch. Index with
    x[..., 1], never with x[1]; write x @ F.T, not F @ x. The filters try the functions at several states, one by one
    and together, before anything is computed.

    Parameters
    ----------
    f : callable
        (..., n) → (..., n), called as f(x), as f(x, u) when a control input u (..., p) is given, or, with three
        parameters, as f(x, u, k) on the way to step k, counted from 0; u is None where there is no input. A parameter
        with a default is the function's own, unless it is called u or k.
    h : callable
        (..., n) → (..., m), called as h(x), h(x, u) or h(x, u, k), with the same u and k: those of the measurement.
    Q : array_like (n, n)
        Covariance of the process noise of one step, or a stack (..., T, n, n).
    R : array_like (m, m)
        Covariance of the measurement noise, or a stack (..., T, m, m); positive definite.
    F_jacobian : callable, optional
        The derivative of f: (..., n, n), or a constant (n, n). It may take u and k like f, or fewer of them. Without
        it central differences are taken.
    H_jacobian : callable, optional
        The derivative of h, likewise: (..., m, n), or a constant (m, n).
    residual : callable, optional
        residual(z, expected): the difference of two measurements (..., m), for angles and other quantities that wrap.
        The default is z − expected; then a filter in which h jumps by a turn (2π or 360) stops and says so.
    scale : float or array_like (n,)
        The size of the states, for the steps of central differences: set it where a state in its unit is far below 1.
    state_residual : callable, optional
        state_residual(x, other): the difference of two states (..., n), where f returns angles that wrap. The default
        is x − other; then a filter in which f jumps by a turn stops and says so.

    Raises
    ------
    ValueError or TypeError
        Naming the argument. What the functions do is looked at when they are used.

    References
    ----------
    Bar-Shalom, Li and Kirubarajan 2001, ch. 10.3.

    Examples
    --------
    >>> import numpy as np
    >>> from kflearn import NonlinearModel
    >>> model = NonlinearModel(f=lambda x: x, h=lambda x: np.hypot(x[..., :1], x[..., 1:]), Q=np.eye(2), R=0.01)
    >>> print(model.measure(np.array([3.0, 4.0])))
    [5.]
    """

    f: Callable
    h: Callable
    Q: np.ndarray
    R: np.ndarray
    F_jacobian: Callable | None = None
    H_jacobian: Callable | None = None
    residual: Callable | None = None
    scale: np.ndarray | float = 1.0
    state_residual: Callable | None = None
    passed: set = field(default_factory=set, init=False, repr=False)  # functions that `arguments` has tried already
    jumps: dict = field(default_factory=dict, init=False, repr=False)  # what `jumps` has found out about f and h
    takes: dict = field(default_factory=dict, init=False, repr=False)  # what each function takes besides x

    def __post_init__(self):
        for name in ("f", "h"):
            if not callable(getattr(self, name)):
                raise TypeError(f"{name} must be a function, got {type(getattr(self, name)).__name__}")
        for name in ("F_jacobian", "H_jacobian", "residual", "state_residual"):
            check.callable_or_none(name, getattr(self, name))
        for name in ("f", "F_jacobian", "h", "H_jacobian"):
            self.takes[name] = takes(getattr(self, name), 2 if name.lower()[0] == "f" else 1)
        object.__setattr__(self, "Q", check.covariance("Q", self.Q))
        object.__setattr__(self, "R", check.covariance("R", self.R, definite=True))
        scale = check.sizes("scale", self.scale, self.n)
        scale.flags.writeable = False
        object.__setattr__(self, "scale", scale)

    @property
    def n(self) -> int:
        """The number of states."""
        return self.Q.shape[-1]

    @property
    def m(self) -> int:
        """The number of measured components."""
        return self.R.shape[-1]

    def replace(self, **changes) -> "NonlinearModel":
        """The same model with some parts changed, e.g. model.replace(R=4)."""
        other = replace(self, **changes)
        if changes.keys() <= {"Q", "R"} and (other.n, other.m) == (self.n, self.m):
            object.__setattr__(other, "passed", self.passed)  # the functions are the same
            object.__setattr__(other, "jumps", self.jumps)
        return other

    def move(self, x, u=None, k=0) -> np.ndarray:
        """f(x), f(x, u) or f(x, u, k), for states x (..., n)."""
        return self.f(x, *self.inputs("f", u, k))

    def measure(self, x, u=None, k=0) -> np.ndarray:
        """h(x), h(x, u) or h(x, u, k), for states x (..., n). Raises ValueError where h(x, u) gets no u."""
        return self.h(x, *self.inputs("h", u, k))

    def move_slope(self, x, u=None, k=0) -> np.ndarray:
        """The Jacobian of f at x (..., n): (..., n, n)."""
        if self.F_jacobian is not None:
            return self.F_jacobian(x, *self.inputs("F_jacobian", u, k))
        difference = watched(self, "f", x, u, k)
        return central_differences(lambda points: self.move(points, u, k), x, difference, self.scale)

    def measure_slope(self, x, u=None, k=0) -> np.ndarray:
        """The Jacobian of h at x (..., n): (..., m, n)."""
        if self.H_jacobian is not None:
            return self.H_jacobian(x, *self.inputs("H_jacobian", u, k))
        difference = watched(self, "h", x, u, k)
        return central_differences(lambda points: self.measure(points, u, k), x, difference, self.scale)

    def difference(self, z, expected) -> np.ndarray:
        """residual(z, expected), or z − expected where no residual was given."""
        return z - expected if self.residual is None else self.residual(z, expected)

    def state_difference(self, x, other) -> np.ndarray:
        """state_residual(x, other), or x − other where none was given."""
        return x - other if self.state_residual is None else self.state_residual(x, other)

    def inputs(self, name, u, k) -> tuple:
        """What a function of this model gets after x: (), (u,) or (u, k). Raises ValueError where h(x, u) gets no u."""
        number, needs_u = self.takes[name]
        if number == 3:
            return u, k
        if u is not None:
            unused = name == "f" and self.takes["h"].number == 1  # an input for nothing: f will say so
            return (u,) if number == 2 or unused else ()
        if needs_u and name in ("h", "H_jacobian"):
            raise ValueError(f"u must be given: {name}(x, u) takes it")
        return ()

    def by_steps(self, *names) -> bool:
        """Does one of these functions change from step to step, so that not all steps can be computed at once?"""
        return any(self.takes[name].number == 3 for name in names)

    def __repr__(self):
        given = ("f", "h", "F_jacobian", "H_jacobian", "residual", "state_residual")
        functions = {name: getattr(self, name) for name in given if getattr(self, name) is not None}
        told = [f"{name} = {name_of(function)}" for name, function in functions.items()]
        told += [f"Q = {in_words(self.Q)}", f"R = {in_words(self.R)}"]
        return f"NonlinearModel with n = {self.n}, m = {self.m}:\n  {', '.join(told)}"


def stacks(model) -> dict[str, np.ndarray]:
    """{name: matrix} of the model's matrices that come as a stack (..., T, rows, columns)."""
    matrices = {name: getattr(model, name, None) for name in "FHBQR"}
    return {name: M for name, M in matrices.items() if M is not None and M.ndim > 2}
