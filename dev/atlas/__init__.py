"""Kalman filters of other libraries on three tiny problems: what each takes and gives, `make atlas`."""
