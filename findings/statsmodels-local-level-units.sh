#!/bin/sh
# statsmodels 0.15.0: UnobservedComponents(z, "llevel").fit() gives other models for the same readings in another unit,
# and says that it has converged.
#
# Expected: multiplying all readings by 1000 multiplies both variances by a million; their ratio, and so the filter's
# gain, stays. Right for the yearly flow of the Nile: irregular 15098.5, level 1469.2, ratio 0.0973.
# Seen: in the unit of the data ratio 0.098; times 0.01 ratio 0.0973; times 1000 the search stops after 0 iterations at
# its first values, 17041 and 10157 (ratio 0.596), with converged = True; an exact diffuse start changes nothing.
# Who is hurt: whoever fits readings in millimetres, volts times 1000, or money in cents: a level variance seven times too
# large, a gain of 0.53 in place of 0.27, and no warning that anybody reads.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet statsmodels==0.15.0 numpy==2.4.6 scipy==1.17.1 pandas==3.1.1
"$folder/env/bin/python" - <<'PYTHON'
import warnings

from statsmodels.datasets import nile
from statsmodels.tsa.statespace.structural import UnobservedComponents

warnings.simplefilter("ignore")
z = nile.load_pandas().data["volume"].to_numpy(float)
for factor, ratio, steps in ((1, 0.0981, 6), (0.01, 0.0973, 7), (1000, 0.596, 0)):
    for exact in (False, True):
        found = UnobservedComponents(z * factor, "llevel", use_exact_diffuse=exact).fit(disp=0)
        irregular, level = found.params / factor**2
        said, taken = found.mle_retvals["converged"], found.mle_retvals["iterations"]
        print(f"times {factor}: {irregular:.1f}, {level:.1f}, {taken} iterations, converged: {said}")
        assert said and abs(level / irregular - ratio) < 0.002, "this has changed"
        assert (taken == 0) == (steps == 0), "this has changed"
PYTHON
