"""The course as a web page."""
