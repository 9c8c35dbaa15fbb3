"""cuthbert

Ask JAX for double precision first. Covariances are handed over as Cholesky factors, so no negative one can be given;
the sign of a factor does not matter. The first of the T + 1 estimates is the start itself. The log-likelihood is a
running sum.
"""

import jax

jax.config.update("jax_enable_x64", True)

import jax.numpy as jnp
from cuthbert import filter as run
from cuthbert.gaussian import kalman

PINS = "cuthbert==0.1.1 jax==0.10.2 numpy==2.4.6"


def plain(F, H, Q, R, x, P, z):
    return same(F, H, Q, R, x, P, z)


def same(F, H, Q, R, x, P, z):
    root_P, root_Q, root_R = (jnp.linalg.cholesky(matrix) for matrix in (P, Q, R))
    readings = jnp.array(z)
    motion = jnp.array(F), jnp.zeros(len(x)), root_Q
    sensor = jnp.array(H), jnp.zeros(len(R)), root_R
    kf = kalman.build_filter(jnp.array(x), root_P, lambda k: motion, lambda k: (*sensor, readings[k]))
    done = run(kf, jnp.arange(len(z)), kf.init_prepare())
    means, covs = done.mean[1:], done.chol_cov[1:] @ done.chol_cov[1:].mT
    return means, covs, done.log_normalizing_constant[-1]
