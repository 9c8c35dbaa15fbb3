"""What builds, measures or attacks the course; each command is started as `python -m dev.…`."""
