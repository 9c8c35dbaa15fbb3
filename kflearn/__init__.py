"""kflearn: the small package behind the course."""
