"""A class on this machine: start kernels, run a lesson in each up to its playground, and move the sliders.

    python -m dev.teaching.load                     30 learners, lesson 05
    python -m dev.teaching.load 12 --lesson 04      12 learners, lesson 04

Printed are the memory of a learner's kernel and the time from a slider's message to the new picture, median (p50) and
the value that 19 of 20 moves stay below (p95): once with the class at work, when each learner moves a slider every two
seconds or so, and once with all of them dragging at the same time. The messages are those of JupyterLab; its server,
which each learner of a JupyterHub has beside the kernel, and the network are not in these times. One such server is
started by itself, for its memory.
"""

import argparse
import asyncio
import json
import math
import os
import random
import secrets
import socket
import statistics
import subprocess
import sys
import tempfile
import time
import urllib.request
from contextlib import AsyncExitStack, suppress
from pathlib import Path
from queue import Empty

import nbformat
import psutil
from jupyter_client.manager import AsyncKernelManager

ROOT = Path(__file__).parents[2]
ENVIRONMENT = os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # as class/jupyterhub_config.py
PATIENCE = 20  # seconds to wait for a picture
WHERE = """
import json
from kflearn.ui.controls import Slider
from kflearn.ui import Playground
found = [thing for thing in globals().values() if isinstance(thing, Playground)][-1]
sliders = [
    dict(name=name, log=c.log, low=c.low, high=c.high, whole=c.number is int, at=c.value)
    for name, c in found.controls.items() if isinstance(c, Slider)
]
print(json.dumps(dict(widget=found.widget.model_id, sliders=sliders)))
"""


def cells_up_to_playground(path):
    """The code of a lesson, up to the cell that shows its last playground."""
    cells = [cell for cell in nbformat.read(path, as_version=4).cells if cell.cell_type == "code"]
    live = [
        number
        for number, cell in enumerate(cells)
        for output in cell.outputs
        if output.get("data", {}).get("text/plain", "").startswith("Playground:")
    ]
    if not live:
        raise ValueError(f"{path.name} shows no playground")
    return [cell.source for cell in cells[: live[-1] + 1]]


class Learner:
    """A kernel in which a lesson has run, and the two hands of whoever reads it."""

    def __init__(self, number):
        self.random, self.waits, self.silent = random.Random(number), [], 0

    async def start(self, cells, stack):
        begun = time.perf_counter()
        while not await self.ready(stack):
            if time.perf_counter() - begun > 300:
                raise RuntimeError("a kernel does not start")
        for cell in cells:
            await self.run(cell)
        where = json.loads(await self.run(WHERE))
        self.widget, self.sliders, self.sent, self.epoch = where["widget"], where["sliders"], 0, 0
        self.say(kind="hello", ratio=1)
        await self.heard(0)
        return self

    async def ready(self, stack):
        """Start a kernel; False if it died at once, as when another has taken its port in the meantime."""
        self.manager = AsyncKernelManager(kernel_name="python3")
        await self.manager.start_kernel(
            cwd=str(ROOT / "notebooks"), env=ENVIRONMENT, extra_arguments=["--log-level=ERROR"]
        )
        stack.push_async_callback(self.stop, self.manager)
        self.client = self.manager.client()
        self.client.start_channels()
        try:
            await self.client.wait_for_ready(timeout=600)
        except RuntimeError:
            self.client.stop_channels()
            return False
        return True

    async def stop(self, manager):
        if manager is self.manager:
            self.client.stop_channels()
        await manager.shutdown_kernel(now=True)

    async def run(self, code):
        """Run a cell; what it printed."""
        printed = []
        reply = await self.client.execute_interactive(
            code,
            timeout=600,
            allow_stdin=False,
            output_hook=lambda message: printed.append(message["content"].get("text", "")),
        )
        if reply["content"]["status"] != "ok":
            raise RuntimeError(f"{reply['content']['ename']}: {reply['content']['evalue']} in\n{code}")
        return "".join(printed)

    def say(self, **what):
        """Send what playground.js would send."""
        data = {"method": "custom", "content": {"view": "learner", **what}}
        message = self.client.session.msg("comm_msg", {"comm_id": self.widget, "data": data})
        self.client.shell_channel.send(message)

    async def heard(self, number):
        """Wait for the picture that answers a move; False where it does not come."""
        begun = time.perf_counter()
        while (left := begun + PATIENCE - time.perf_counter()) > 0:
            with suppress(Empty):
                news = await self.client.get_iopub_msg(timeout=left)
                said = news["content"].get("data", {}).get("content", {})
                if said.get("kind") == "picture" and said["n"] == number and news["buffers"]:
                    self.epoch = said["epoch"]
                    return True
        return False

    async def move(self):
        """Move a slider, as the browser does, and wait for the picture. Notes how long that took."""
        slider = self.random.choice(self.sliders)
        slider["at"] = place(slider, self.random)
        self.sent += 1
        sent = time.perf_counter()
        self.say(kind="move", n=self.sent, epoch=self.epoch, values={slider["name"]: slider["at"]})
        if await self.heard(self.sent):
            self.waits.append(time.perf_counter() - sent)
        else:
            self.silent += 1

    async def play(self, moves, pause):
        """Some moves, with pauses between them that last `pause` seconds on average."""
        for _ in range(moves):
            await asyncio.sleep(self.random.uniform(0, 2 * pause))
            await self.move()


def place(slider, chance):
    """Another value of a slider than that of now."""
    low, high = (math.log10(end) if slider["log"] else end for end in (slider["low"], slider["high"]))
    while True:
        at = chance.uniform(low, high)
        value = min(max(10**at, slider["low"]), slider["high"]) if slider["log"] else at
        value = round(value) if slider["whole"] else value
        if value != slider["at"]:
            return value


def memory(pid):
    """Megabytes of a process: RSS, and PSS, which shares what is in memory once among all who use it (Linux)."""
    rss = psutil.Process(pid).memory_info().rss / 1e6
    try:
        rollup = Path(f"/proc/{pid}/smaps_rollup").read_text(encoding="utf-8")
        pss = next(int(line.split()[1]) for line in rollup.splitlines() if line.startswith("Pss:")) * 1024 / 1e6
    except OSError:
        pss = float("nan")
    return rss, pss


def server_memory():
    """Megabytes (RSS, PSS) of a JupyterLab server that has just started and has been asked for its page."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    token = secrets.token_hex(16)
    with tempfile.TemporaryDirectory() as home:
        places = ("JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR")
        command = [sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root", "--ip=127.0.0.1"]
        command += [f"--port={port}", f"--IdentityProvider.token={token}", f"--ServerApp.root_dir={home}"]
        process = subprocess.Popen(
            command,
            env=ENVIRONMENT | {place: f"{home}/{place}" for place in places},
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        try:
            for _ in range(600):
                with suppress(OSError):
                    urllib.request.urlopen(f"http://127.0.0.1:{port}/lab?token={token}", timeout=30).read()
                    return memory(process.pid)
                if process.poll() is not None:
                    break
                time.sleep(0.1)
            raise RuntimeError("the JupyterLab server did not start")
        finally:
            process.terminate()
            process.wait()


def percentiles(waits):
    """Median, and what 19 of 20 stay below, in milliseconds."""
    places = statistics.quantiles(waits, n=20, method="inclusive")
    return {"p50": 1000 * statistics.median(waits), "p95": 1000 * places[-1], "moves": len(waits)}


async def measure(kernels=30, lesson="05", moves=15, pause=2.0):
    """All that is printed, as a dictionary."""
    path = next((ROOT / "notebooks").glob(f"{lesson:0>2}-*.ipynb"))
    cells, result = cells_up_to_playground(path), {"lesson": path.stem, "kernels": kernels}
    async with AsyncExitStack() as stack:
        begun = time.perf_counter()
        learners = await asyncio.gather(*(Learner(number).start(cells, stack) for number in range(kernels)))
        result["ready"] = time.perf_counter() - begun
        for name, each in {"at work": pause, "all at once": 0.0}.items():
            await asyncio.gather(*(learner.play(moves, each) for learner in learners))
            result[name] = percentiles([wait for learner in learners for wait in learner.waits])
            result[name]["silent"] = sum(learner.silent for learner in learners)
            for learner in learners:
                learner.waits, learner.silent = [], 0
        sizes = [memory(learner.manager.provisioner.pid) for learner in learners]
    result["rss"], result["pss"] = (statistics.median(size) for size in zip(*sizes, strict=True))
    result["largest"] = max(size[0] for size in sizes)
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kernels", nargs="?", type=int, default=30)
    parser.add_argument("--lesson", default="05")
    parser.add_argument("--moves", type=int, default=15, help="of each learner, in each of the two rounds")
    parser.add_argument("--pause", type=float, default=2.0, help="seconds between two moves of a learner at work")
    options = parser.parse_args()
    found = asyncio.run(measure(options.kernels, options.lesson, options.moves, options.pause))
    rss, pss = server_memory()
    busy = ", ".join(f"{load:.1f}" for load in os.getloadavg()) if hasattr(os, "getloadavg") else "unknown"
    print(f"{found['kernels']} kernels, lesson {found['lesson']}, {os.cpu_count()} cores (load average {busy})")
    print(f"all started at once, lesson run up to the playground: the last was ready after {found['ready']:.0f} s")
    print(f"memory of a kernel         RSS {found['rss']:4.0f} MB, PSS {found['pss']:4.0f} MB (median)", end="")
    print(f", largest RSS {found['largest']:.0f} MB")
    print(f"memory of a server         RSS {rss:4.0f} MB, PSS {pss:4.0f} MB (one, measured by itself)")
    print("slider → new picture           p50        p95   moves")
    for name in ("at work", "all at once"):
        times = found[name]
        print(f"  {name:22}{times['p50']:8.0f} ms{times['p95']:8.0f} ms{times['moves']:8}", end="")
        print(f"   ({times['silent']} without a new picture)" if times["silent"] else "")


if __name__ == "__main__":
    main()
