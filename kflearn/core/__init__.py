"""Array mathematics: angles, matrices, conditioning, recursions. Arguments are not checked here."""
