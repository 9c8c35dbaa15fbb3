"""How hard is the course to break? `make check-hard`, or

    python -m dev.hard                       all parts: minutes, not seconds
    python -m dev.hard values inputs        some
    python -m dev.hard --quick               all parts, each much smaller: does the machinery itself still work?

One table is printed: what was tried, the measured figure, its bound. The command fails if a line does.

Each part is a module beside this one with a function `lines(quick)` that yields Line.
"""

import argparse
import sys
import time
from importlib import import_module

from dev.hard.line import Line

PARTS = "values", "inputs", "lessons", "browser", "security", "speed"


def row(line):
    return f"{'ok ' if line.ok else 'NO '} {line.what:58} {line.measured:>32}   {line.bound}"


def run(part, quick):
    """The lines of a part, printed as they come. A part that breaks off is a line that fails."""
    begun, found = time.monotonic(), []
    print(f"\n{part}", flush=True)
    try:
        for line in import_module(f"dev.hard.{part}").lines(quick):
            found.append(line)
            print(row(line), flush=True)
    except Exception as error:
        found.append(Line("broke off", f"{type(error).__name__}: {error}", "no error", False))
        print(row(found[-1]), flush=True)
    print(f"    {time.monotonic() - begun:.0f} s", flush=True)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", help=f"of {', '.join(PARTS)}")
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    if unknown := set(options.parts) - set(PARTS):
        parser.error(f"no such part: {', '.join(sorted(unknown))}")
    found = [line for part in options.parts or PARTS for line in run(part, options.quick)]
    failed = [line for line in found if not line.ok]
    print(f"\n{len(found)} lines, {len(failed)} not kept")
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
