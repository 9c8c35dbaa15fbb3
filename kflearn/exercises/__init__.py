"""The exercises of the course, one module a lesson; each exercise has check, hint and solution.

    from kflearn.exercises import gaussian_fusion as exercises

    exercises.fused_position.check(61.7)

Lesson authors make exercises with the decorator `kflearn.exercises.engine.exercise`.
"""
