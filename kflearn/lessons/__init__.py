"""The lessons as they came with this version, and the command `kflearn`, for those who have no clone of the course."""
