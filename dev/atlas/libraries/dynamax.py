"""dynamax

Ask JAX for double precision first. A gap is not known; give it a variance of the measurement noise so large that it
counts nothing, step by step. 1e-9 is added to each innovation variance, so the last digits differ.
"""

import jax

jax.config.update("jax_enable_x64", True)

import jax.numpy as jnp
import numpy as np
from dynamax.linear_gaussian_ssm import LinearGaussianSSM, lgssm_filter

PINS = "dynamax==1.0.3 jax==0.10.2 numpy==2.4.6"


def plain(F, H, Q, R, x, P, z):
    ssm = LinearGaussianSSM(state_dim=len(x), emission_dim=len(R))
    names = dict(initial_mean=x, initial_covariance=P, dynamics_weights=F, dynamics_covariance=Q)
    params, _ = ssm.initialize(jax.random.PRNGKey(0), **names, emission_weights=H, emission_covariance=R)
    done = lgssm_filter(params, jnp.array(z))
    return done.filtered_means, done.filtered_covariances, done.marginal_loglik


def same(F, H, Q, R, x, P, z):
    ssm = LinearGaussianSSM(state_dim=len(x), emission_dim=len(R))
    names = dict(initial_mean=F @ x, initial_covariance=F @ P @ F.T + Q, dynamics_weights=F, dynamics_covariance=Q)
    noise = jnp.array(np.where(np.isnan(z).any(axis=1)[:, None, None], 1e12 * R, R))
    params, _ = ssm.initialize(jax.random.PRNGKey(0), **names, emission_weights=H, emission_covariance=noise)
    done = lgssm_filter(params, jnp.nan_to_num(jnp.array(z)))
    return done.filtered_means, done.filtered_covariances
