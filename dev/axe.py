"""axe-core, which looks for what keeps people with screen readers and keyboards out; for the tests, from npm."""

import io
import shutil
import subprocess
import tarfile
import tempfile
from functools import cache
from pathlib import Path

VERSION = "4.14.1"
KEPT = Path(__file__).parents[1] / "build" / "axe" / f"axe-{VERSION}.js"
RUN = """async part => {
  const found = await axe.run(part, { resultTypes: ["violations"] });
  const bad = found.violations.filter(each => ["serious", "critical"].includes(each.impact));
  return bad.map(each => `${each.id}: ${each.nodes.map(node => node.html).join(" | ").slice(0, 400)}`);
}"""


@cache
def source() -> str | None:
    """The script; None where it is neither kept from before nor to be had from npm."""
    npm = shutil.which("npm")
    if not KEPT.exists() and npm:
        with tempfile.TemporaryDirectory() as folder:
            command = [npm, "pack", "--silent", "--fetch-retries=0", "--fetch-timeout=20000", f"axe-core@{VERSION}"]
            if subprocess.run(command, cwd=folder, capture_output=True, timeout=60).returncode == 0:
                keep(Path(folder, f"axe-core-{VERSION}.tgz").read_bytes())
    return KEPT.read_text(encoding="utf-8") if KEPT.exists() else None


def keep(package):
    """Take the script out of npm's package."""
    with tarfile.open(fileobj=io.BytesIO(package)) as files:
        script = files.extractfile("package/axe.min.js").read()
    KEPT.parent.mkdir(parents=True, exist_ok=True)
    part = KEPT.with_suffix(".part")
    part.write_bytes(script)
    part.replace(KEPT)  # at once: two tests may fetch it at the same time


def faults(page, part=".kf-playground") -> list[str]:
    """What axe-core calls serious or critical in a part of a page ("html" is the whole), with its elements."""
    if not page.evaluate("'axe' in window"):
        page.evaluate(source())
    return page.evaluate(RUN, part)
