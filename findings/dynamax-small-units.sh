#!/bin/sh
# dynamax 1.0.3: the linear filter takes small variances for larger ones, in double precision too: in metres a signal
# of micrometres is filtered wrongly.
#
# Expected: Kalman's gain depends on ratios of variances. With Q = R = P = 1e-12 (micrometres, told in metres) the
# filter gives the same gain as with Q = R = P = 1 (told in micrometres): 0.5 for the first reading.
# Seen: 0.000998. The filtered variance is 1.0e-12 in place of 5e-13, and the estimate hardly leaves its start. It
# behaves as if 1e-9 were added to each innovation variance.
# Who is hurt: whoever fits or filters readings in SI units where they are small: displacements, currents, magnetic
# fields in tesla. No warning; multiplying by a million is the remedy.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet dynamax==1.0.3 jax==0.10.2 numpy==2.4.6
"$folder/env/bin/python" - <<'PYTHON'
import jax

jax.config.update("jax_enable_x64", True)

import jax.numpy as jnp
from dynamax.linear_gaussian_ssm import LinearGaussianSSM, lgssm_filter


def first_step(unit):
    """Gain and variance of the first reading, in the units of the variance; all variances are unit²."""
    one, small = jnp.eye(1), unit**2 * jnp.eye(1)
    ssm = LinearGaussianSSM(state_dim=1, emission_dim=1)
    told = {"initial_mean": jnp.zeros(1), "initial_covariance": small, "dynamics_weights": one}
    told |= {"dynamics_covariance": small, "emission_weights": one, "emission_covariance": small}
    params, _ = ssm.initialize(jax.random.PRNGKey(0), **told)
    done = lgssm_filter(params, jnp.array([[unit]]))
    return done.filtered_means[0, 0] / unit, done.filtered_covariances[0, 0, 0] / unit**2


for unit, gain in ((1.0, 0.5), (1e-6, 0.000998)):
    found, variance = first_step(unit)
    print(f"σ = {unit:g}: gain {found:.6f} (right 0.5), variance {variance:.6f} σ² (right 0.5 σ²)")
    assert abs(found - gain) < 1e-6 + 1e-8 and abs(variance - (1 - gain)) < 2e-3, "this has changed"
PYTHON
