"""How fast and how large it is, beside other libraries."""
