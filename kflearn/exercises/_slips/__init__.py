"""Wrong answers to the exercises, each with the sentence that it gets: a package for each lesson, a module for each exercise."""
