"""How a learner's file becomes a Recording: parts of `kflearn.recordings`, each with one task.

layout (where columns and header are) → rows (the table) → clock and order (time) → columns (readings) → recording.
"""
