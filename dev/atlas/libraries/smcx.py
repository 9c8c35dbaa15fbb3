"""smcx

Ask JAX for double precision first. A gap is not known; give it a variance of the measurement noise so large that it
counts nothing.
"""

import jax

jax.config.update("jax_enable_x64", True)

import jax.numpy as jnp
import numpy as np
import smcx

PINS = "smcx==2.1.0 jax==0.10.2 numpy==2.4.6"


def plain(F, H, Q, R, x, P, z):
    done = smcx.kalman_filter(x, P, F, Q, H, R, jnp.array(z))
    return done.filtered_means, done.filtered_covariances, done.marginal_loglik


def same(F, H, Q, R, x, P, z):
    noise = np.where(np.isnan(z).any(axis=1)[:, None, None], 1e12 * R, R)
    done = smcx.kalman_filter(F @ x, F @ P @ F.T + Q, F, Q, H, noise, jnp.nan_to_num(jnp.array(z)))
    return done.filtered_means, done.filtered_covariances
