"""Beliefs and models, how they are simulated, and the checks of what users hand in."""
