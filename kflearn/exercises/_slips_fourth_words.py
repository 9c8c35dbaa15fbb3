"""What is said of choices that a fourth group of strangers wrote in words of their own (lessons 14 to 23)."""

from kflearn.exercises._words import heard

WINNER = heard(
    {
        r"median": "Asked is the rms error over all runs. In it the bad runs count, which a median run hides.",
        r"ukf|unscented": "The unscented filter is not one of the two: compared are the LKF and the EKF.",
    }
)
REVIEW = heard(
    {
        r"root|sqrt|line 2": "That is reviewer (a): answer with the letter. But look whether a bearing's slope needs the distance or its square.",
        r"sign|minus|line 3": "That is reviewer (b), or (c) for the zeros: answer with the letter. But try a target due east that moves north.",
    }
)
PUSHED = "G enters only by Q = G q Gᵀ. Which q has the straight model?"
PUSH = heard(
    {
        r"(little|bit|slight|somewhat)": f"Not even a little: {PUSHED}",
        r"twice|double|half|times": f"By no factor: {PUSHED}",
        r"turn|straight|depends|both": f"It does not depend on turns: {PUSHED}",
    }
)
NOISY = heard(
    {
        r"^0?\.8\d*$|corr|neighb": "You read the right number. What makes neighbours alike by 0.85, white noise or a board that turns? Hand in the letter.",
        r"^d$|none|neither": "One of the three is right: hand in A, B or C, and look at the correlation of neighbours.",
        r"turn|mov|board": "The motion of the board: which letter is that?",
    }
)
GAP = heard(
    {
        r"^-?0?\.03": "That is the difference in ppm. Divide the two errors: which letter says how large their ratio is?",
        r"^0?\.9": "The ratio is right. Which of A, B and C says so? Hand in the letter.",
        r"^none|neither": "One of the three is right. About two standard errors are a weak sign; but asked is what the two printed errors say. Divide them, and hand in A, B or C.",
    }
)
