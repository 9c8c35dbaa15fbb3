"""What a number would mean, for an answer that is in no table: a fact that holds of every answer (lessons 15 to 28)."""

import numpy as np

from kflearn.exercises._answers import show


def nees_of(sigma):
    """Lesson 16, start_sigma."""
    return f"With σ = {show(sigma)} m on each axis the NEES is {show(341600 / sigma**2, 3)}, where 3 is wanted. It goes with 1/σ²."


def relative_of(velocity):
    """Lesson 15, twin_velocity."""
    east, north = velocity - [6, 0]
    return (
        f"Relative to us that target moves with ({show(east)}, {show(north)}) m/s. The true one moves with (−3, −2) m/s, and the "
        "twin, twice as far away, with twice of that."
    )


def weight_of_centre(mean):
    """Lesson 17, three_points."""
    low = 100 * np.cos(np.radians(30) * 3**0.5)
    if 12.5 < mean < 13.2:
        return "That is about how far the mean sinks below 100 m. The question asks for the mean itself."
    if not low <= mean <= 100:
        return "A weighted mean lies between the smallest and the largest image, here between 61 m and 100 m."
    return (
        f"With the points at 90° and 90° ± √3 · 30° that number gives the centre the weight {show((mean - low) / (100 - low), 3)}. "
        "By the rule it is 1 − n/scale = 2/3."
    )


def declared(kappas):
    """Lesson 17, declared_kappa."""
    one, half = kappas
    if 3 - one == 12 - half:
        return f"3 − {show(3 - one)} and 12 − {show(3 - one)}: that would be right for n = {show(3 - one)}. The program has four states."
    if (one, half) == (-5, -8):
        return "Here α²(n + κ) is −1, which is λ itself. It equals n + λ, which is 3."
    found = [show(a * (4 + kappa), 3) for a, kappa in ((1, one), (0.25, half))]
    return f"With your κ the scale α²(4 + κ) is {found[0]} for α = 1 and {found[1]} for α = ½. The program works with 3 both times."


def six_ratios(sum_of_them):
    """Lesson 17, start_nees."""
    if sum_of_them > 6:
        return "More than 6 would mean real errors that are larger than P₀ claims. Here they are much smaller: add up six ratios, real to claimed."
    if sum_of_them > 0.06:
        return "Six ratios are added, real to claimed, and none of them is larger than 1/100: the sum is at most 0.06."
    return "Six ratios are added, real to claimed. Four of them are 1/100, the other two are smaller: the sum is between 0.04 and 0.06."


def spread_of(sigma):
    """Lesson 18, blended_sigma."""
    if sigma <= 30:
        return "The blend is wider than each of the two, 30 m: their means are apart as well."
    return (
        f"Its square is 900 m² and {show(sigma**2 - 900)} m² more. What is added to 900 m² is the squared distance of each mean "
        "from the middle."
    )


ACCELERATIONS = {
    0.06: "what is subtracted too much",
    0.03: "6 % of 0.5 m/s², the scale error once",
    0.13: "what the filter has learnt",
    0.07: "what the sensor shows too much while the tram brakes",
    0.1: "the bias alone",
    0.16: "the learnt 0.13 m/s² and 0.03 m/s² more",
    0.2: "twice the bias, or the learnt 0.13 m/s² and the 0.07 m/s² of braking added",
    0.26: "twice the learnt 0.13 m/s²",
    0.5: "the true acceleration",
    0.53: "the true acceleration with its 6 %",
    0.47: "the true acceleration less its 6 %",
    0.6: "the true acceleration and the bias together",
    0.63: "all that the sensor shows while the tram pulls",
    0.43: "how much the sensor shows while the tram brakes, 0.5 m/s² less 0.07 m/s²",
    0.4: "the true acceleration less the bias",
}  # m/s²


def acceleration_of(metres):
    """Lesson 20, all_bias."""
    size = abs(metres)
    for a, name in ACCELERATIONS.items():
        made = {
            a: f"{show(a)} m/s² is an acceleration: {name}.",
            30
            * a: f"{show(size)} m/s is a speed, the one that {show(a)} m/s² makes in 30 s. {show(a)} m/s² is {name}.",
            900 * a: f"{show(size)} is {show(a)} · 30². {show(a)} m/s² is {name}.",
            450 * a: f"{show(size)} m is what {show(a)} m/s² makes in 30 s. {show(a)} m/s² is {name}.",
        }
        if said := [sentence for value, sentence in made.items() if abs(size - value) < 1e-9]:
            return (
                f"{said[0]} Which acceleration is left over: what the filter subtracts, less what the sensor shows too much while "
                "braking? It makes b·t²/2 metres."
            )
    return (
        f"Over 30 s that is what an acceleration of {show(2 * metres / 900, 3)} m/s² makes, by b·t²/2. Which one is left over: what the "
        "filter subtracts, less what the sensor shows too much while braking?"
    )


def deviation_of(R):
    """Lesson 21, inflated."""
    if R <= 0:
        return "A variance is larger than 0: the squares of 0.3 m and 0.5 m add."
    return f"That R belongs to an error of σ = {show(R**0.5, 3)} m. Noise (0.3 m) and bias (0.5 m) are independent: their squares add."


def scatter_of(count):
    """Lesson 22, window_needed."""
    if count <= 0:
        return None
    return f"With {show(count)} innovations R̂ scatters by S √(2/N) = {show(1.3 * (2 / count) ** 0.5, 3)} m², with S = 1.3 m². Wanted is 0.1 m²."


def gain_of(belief):
    """Lesson 23, one_step_back."""
    mean, variance = belief
    if abs(mean - 5.5) < 1e-6:
        return f"The mean is right. Your variance is 3 and {show(variance - 3, 3)} more: added to 3 is G² (2 − 4), with G = 3/4."
    return f"Your mean has moved by {show((mean - 4) / 2, 3)} times 6 − 4. The gain is G = P/P⁻ = 3/4; the variance is 3 + G² (2 − 4)."


def slope_at(R):
    """Lesson 24, half_missing."""
    if R <= 0:
        return "R is a variance, and larger than 0."
    slope = 1 / R - 2 / R**2
    way = "smaller" if slope > 0 else "larger"
    return f"At R = {show(R)} the sum ½·4/R + log R has the slope {show(slope, 2)}: it is still lower for a {way} R."


def density_of(log_likelihood):
    """Lesson 24, one_reading."""
    top = -np.log(2 * np.pi * 5) / 2
    if log_likelihood > top:
        return f"{show(log_likelihood)} is more than the bell of variance 5 V² has in its middle, {show(top, 3)}. The reading is 3 V off: −½(log 2πS + y²/S)."
    return (
        f"In its middle the bell of variance 5 V² has {show(top, 3)}, and your number is lower by {show(top - log_likelihood, 3)}. For "
        "a reading that is off by y it is lower by ½·y²/S."
    )


def speed_of(metres):
    """Lesson 25, behind."""
    way = "behind" if metres < 0 else "ahead of"
    return (
        f"In 0.24 s that is a speed of {show(abs(metres) / 0.24, 3)} m/s, and the reading would lie {way} the bus. 54 km/h are 15 m/s, and "
        "the reading tells where the bus was before the stamp."
    )


def area_of(number):
    """Lesson 26, false_in_gate."""
    if number <= 0:
        return "In a gate of any size there are some on average: its area, in m², times 0.0005."
    if abs(number - 868) < 3:
        return "That is the area of the gate, in m². How many false readings are in it, at 0.0005 for each m²?"
    if abs(number - 868 / 0.0005) < 5e3:
        return "That is the area divided by λ. So many false readings in each m², times so many m²: multiply."
    return (
        f"At 0.0005 for each m² that is a gate of {show(number / 0.0005, 3)} m². The gate is an ellipse with the half axes √9.21 · 6 m "
        "and √9.21 · 5 m."
    )


def readings_of(pair):
    """Lesson 26, zeros."""
    strange = [each for each in np.ravel(pair) if each not in (1, 2, 3)]
    return (
        f"There is no reading {show(strange[0])}: the table has the readings 1 to 3, and each track gets one."
        if strange
        else None
    )


def limits_of(limits):
    """Lesson 27, interval_of_R."""
    from scipy.stats import chi2

    low, high = limits
    if not 0 < low < high:
        return "Two variances are wanted, both larger than 0, the lower limit first."
    parts = [100 * chi2.sf(40 * 0.09 / low, 40), 100 * chi2.cdf(40 * 0.09 / high, 40)]
    return (
        f"If R were your lower limit, a sample variance of 0.09 m² or more would have a probability of {show(parts[0], 2)} %; if R were "
        f"the upper one, 0.09 m² or less one of {show(parts[1], 2)} %. At 95 % both are 2.5 %."
    )


def in_thousands(q):
    """Lesson 27, milliseconds_for_seconds."""
    if q <= 0:
        return "q is a variance a time, and larger than 0."
    return f"Then q Δt³/3, with a Δt that is 1000 times too large, becomes {show(q * 1e10, 3)} times what it was. It is to stay as it was."


def older_than_ten(share):
    """Lesson 28, newest_ten."""
    if not 0 <= share <= 1:
        return "A share of the whole is between 0 and 1."
    return f"That leaves {show(1 - share, 3)} to the readings older than the newest ten. One reading leaves 0.85 of the whole; what do ten of them leave?"


def next_night(distance):
    """Lesson 28, behind."""
    after = (distance + 0.3) * (1 - 0.2207)
    if distance < 0:
        return "The estimate trails, so the distance is a positive number: each night adds 0.3 s, and the part K is taken away."
    return f"From {show(distance)} s the clock goes on to {show(distance + 0.3)} s, and the reading leaves {show(after)} s: not the same distance as the night before."
