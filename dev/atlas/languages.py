"""How a problem is written in R, gretl's hansl, Octave and JavaScript, and how its numbers are printed there.

Each language gets every quantity as a matrix of two dimensions, also x (n, 1), and what is missing in its own word.
The library's lines leave means, covs and, where the library has one, log_likelihood; the tail prints them by steps.
"""

from typing import NamedTuple


class Language(NamedTuple):
    """program: what is to be installed. start: the command before the script's name. fence: its name on the page."""

    program: str
    start: tuple
    version: tuple
    comment: str
    fence: str
    matrix: str
    between: str
    missing: str
    tail: str


R_TAIL = """
for (name in c("means", "covs")) {
  by_step <- if (name == "means") t(means) else aperm(covs, c(2, 3, 1))
  cat(name, sprintf("%.17g", by_step), "\\n")
}
if (exists("log_likelihood")) cat("log_likelihood", sprintf("%.17g", log_likelihood), "\\n")
"""
HANSL_TAIL = """
matrices both = defarray(means, covs)
strings names = defarray("means", "covs")
loop i = 1..2
    matrix by_step = vec(both[i]')
    printf "%s", names[i]
    loop j = 1..rows(by_step)
        printf " %.17g", by_step[j]
    endloop
    printf "\\n"
endloop
if exists(log_likelihood)
    printf "log_likelihood %.17g\\n", log_likelihood
endif
"""
OCTAVE_TAIL = """
printf("means"); printf(" %.17g", means'); printf("\\n");
printf("covs"); printf(" %.17g", covs); printf("\\n");
if exist("log_likelihood", "var"), printf("log_likelihood %.17g\\n", log_likelihood); end
"""
JAVASCRIPT_TAIL = """
console.log("means", means.flat(Infinity).join(" "));
console.log("covs", covs.flat(Infinity).join(" "));
if (typeof log_likelihood !== "undefined") console.log("log_likelihood", log_likelihood);
"""
CONTROL = "pkg load control; printf('%s', ver('control').Version)"

LANGUAGES = {
    ".R": Language(
        program="R",
        start=("Rscript", "--vanilla"),
        version=("Rscript", "--vanilla", "-e", "cat(format(getRversion()))"),
        comment="#",
        fence="r",
        matrix="{name} <- matrix(c({rows}), {count}, byrow = TRUE)",
        between=", ",
        missing="NA",
        tail=R_TAIL,
    ),
    ".inp": Language(
        program="gretl",
        start=("gretlcli", "-b", "-q"),
        version=("gretlcli", "--version"),
        comment="#",
        fence="text",
        matrix="matrix {name} = {{{rows}}}",
        between="; ",
        missing="NA",
        tail=HANSL_TAIL,
    ),
    ".m": Language(
        program="Octave with its package control",
        start=("octave-cli", "--norc", "--no-history"),
        version=("octave-cli", "--norc", "--no-history", "--eval", CONTROL),
        comment="#",
        fence="octave",
        matrix="{name} = [{rows}];",
        between="; ",
        missing="NaN",
        tail=OCTAVE_TAIL,
    ),
    ".js": Language(
        program="Node with npm",
        start=("node",),
        version=("npm", "--version"),
        comment="//",
        fence="javascript",
        matrix="const {name} = [[{rows}]];",
        between="], [",
        missing="NaN",
        tail=JAVASCRIPT_TAIL,
    ),
}
