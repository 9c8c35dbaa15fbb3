"""Wrong answers to exercises of lesson 1, each with the sentence that it gets."""

import numpy as np


def first_wrong_row(H):
    """What to look at, for an H of the right form: the first sensor whose row is not right."""
    rows = {"the tape in metres": [1, 0], "the tape in centimetres": [100, 0], "the speedometer": [0, 3.6]}
    names = [name for row, (name, right) in zip(H, rows.items(), strict=True) if not np.allclose(row, right)]
    if np.isclose(H[1][0], 100 * H[0][0]) and abs(H[0][0]) > 1.5 and not (H[0][1] or H[1][1]):
        return (
            f"These look like readings: a tape that shows {H[0][0]:g} m. H holds no readings, but what each sensor shows for "
            "1 m and 0 m/s (first column), and for 0 m and 1 m/s (second column)."
        )
    return f"Look at the {'row' if len(names) == 1 else 'rows'} of {' and '.join(names)}: what is shown for 1 m and 0 m/s, and what for 0 m and 1 m/s?"
