"""A learner's code while it runs: what it prints is kept short and shown, and it is stopped when it takes too long."""

import _thread
import contextlib
import io
import signal
import threading
import time
import warnings

import numpy as np

SECONDS = 10  # that a check may work; on a busy machine it may take three times as long
SIGNS = 600  # of what is printed that are shown


class TooLong(BaseException):
    """The learner's code was stopped; `except Exception` in it does not catch this."""


class Printed(io.TextIOBase):
    """Takes what is printed, keeps the beginning, and counts the rest."""

    def __init__(self):
        self.kept, self.length, self.calls = io.StringIO(), 0, 0

    def writable(self):
        return True

    def write(self, text):
        if self.calls:
            return len(text)
        self.kept.write(text[: max(0, SIGNS - self.length)])
        self.length += len(text)
        return len(text)

    def close_after_first(self, calls):
        """Of a function that is called so often, only what the first call printed is kept."""
        self.calls = calls

    def text(self) -> str:
        """What is shown of it; empty where nothing was printed."""
        left_out, text = self.length - SIGNS, self.kept.getvalue()
        text += f"\n… and {left_out:,} characters more" if left_out > 0 else ""
        text += "" if not text or text.endswith("\n") else "\n"
        return text + (f"(printed in the first of {self.calls} calls)\n" if text and self.calls > 1 else "")


@contextlib.contextmanager
def watched(printed, limit=True):
    """Run code with its prints taken, without warnings, and `in_time` if there is to be a limit."""
    with contextlib.redirect_stdout(printed), warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        with in_time() if limit else contextlib.nullcontext():
            yield


def in_time():
    """A context in which code may work for SECONDS: then TooLong is raised in it."""
    main = threading.current_thread() is threading.main_thread()
    return _limit(SECONDS) if main else contextlib.nullcontext()


@contextlib.contextmanager
def _limit(seconds):
    """Interrupt the main thread, where cells run, as Ctrl+C does; here that raises TooLong. In a browser, no limit."""
    lock, late, over, began = threading.Lock(), threading.Event(), threading.Event(), time.process_time()

    def interrupted(number, frame):
        if late.is_set():
            raise TooLong
        (before if callable(before) else signal.default_int_handler)(number, frame)

    def stop():
        _wait_for_work(seconds, began, over)
        with lock:
            if not over.is_set():
                late.set()
                _thread.interrupt_main()

    before, timer = signal.signal(signal.SIGINT, interrupted), threading.Timer(seconds, stop)
    timer.daemon = True
    with contextlib.suppress(RuntimeError):  # Python in a browser has one thread: nobody there can interrupt it
        timer.start()
    try:
        try:
            yield
        finally:
            with lock:
                over.set()  # from here on nothing is interrupted any more
    finally:  # also where the interruption arrives in the line above
        timer.cancel()
        signal.signal(signal.SIGINT, before)


def _wait_for_work(seconds, began, over):
    """Where other programs had the processor, wait until so much work is done; three times as long at most."""
    end = time.monotonic() + 2 * seconds
    while time.process_time() - began < seconds and time.monotonic() < end:
        if over.wait(seconds / 100):
            return
