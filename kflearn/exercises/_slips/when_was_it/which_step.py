"""Lesson 25, `which_step`: wrong answers, each with the sentence that it gets."""

LINES = {
    1: "Line 1 only names what is handed in. Look at what is done with it, and at what is never used.",
    2: "F carries the state over dt seconds, as it should. Which dt is it given?",
    3: "This is the white Q of lesson 1, for dt seconds. Which dt is it given?",
    5: "All readings must be gone through, in the order of time. That they are.",
    6: "To predict for dt[k] before the reading k is right, if dt[k] is the step that ends there. Is it?",
    7: "The innovation and its variance are right. They come after the prediction; how long was that?",
    8: "The correction is right: K y is added to the mean, and K S Kᵀ is taken off.",
    9: "Line 9 only gives back the last belief.",
}


WRONG = {str(line): ({line}, sentence) for line, sentence in LINES.items()}
