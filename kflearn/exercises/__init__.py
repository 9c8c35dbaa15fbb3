"""The exercises of the course, one module a lesson; each exercise has check, hint and solution."""
