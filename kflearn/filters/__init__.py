"""Filters and smoothers."""
