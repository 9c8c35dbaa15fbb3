"""Whose reading is it? Scans of several readings, some of them false: gates, weights, assignments, tracks."""
