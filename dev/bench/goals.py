"""How a figure stands to its goal, as a word in a table."""

SHORT = "short"  # stands beside a figure that does not keep its goal


def times(ratio):
    """So many times as quick, as a word in a table."""
    return f"{ratio:,.0f}" if ratio >= 10 else f"{ratio:.2f}"


def judged(ratio, goal, at_most=False):
    """The ratio, in bold with a word where it is short of its goal; without a goal in bold where a rival is quicker."""
    if goal is None:
        return times(ratio) if ratio >= 1 else f"**{times(ratio)}**"
    return times(ratio) if (ratio <= goal if at_most else ratio >= goal) else f"**{times(ratio)}, {SHORT}**"
