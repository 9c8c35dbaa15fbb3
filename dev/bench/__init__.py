"""How fast and how large it is, beside other libraries."""

import os

os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")  # before NumPy is opened: one thread for everybody
