"""Hard to break: `make check-hard` tries, measures and prints."""
