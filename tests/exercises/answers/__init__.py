"""Answers that strangers handed in, a module for each lesson.

RIGHT holds (exercise, answer). TOLD holds (exercise, answer, words of the reply), and in some rows
words that it does not hold.
"""
