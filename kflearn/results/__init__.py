"""What a filter returns, and how it is judged."""
