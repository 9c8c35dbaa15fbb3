"""For teachers: assignments and their grading, slides, a class's load, a class server."""
