"""Python runs this file at its start where this folder is on PYTHONPATH: a machine without network, and a course that
must name the encoding of every file it opens.

An attempt to reach another machine, and the names of it, are refused and noted in the file that HARD_LOG names.
"""

import os
import sys
import warnings

OUTWARD = {
    "socket.connect": 1,
    "socket.sendto": 1,
    "socket.sendmsg": 1,
    "socket.getaddrinfo": 0,
    "socket.gethostbyname": 0,
}
NEAR = ("127.", "0.", "::1", "localhost")


def refuse(event, details):
    """An audit hook: raises where a socket would leave this machine."""
    if event not in OUTWARD:
        return
    address = details[OUTWARD[event]]
    host = address[0] if isinstance(address, tuple) else address
    if host is None or isinstance(address, bytes) or str(host).startswith((*NEAR, "/")):
        return
    with open(os.environ["HARD_LOG"], "a", encoding="utf-8") as log:
        log.write(f"{event} {host}\n")
    raise PermissionError(f"no network here: {host}")


sys.addaudithook(refuse)
warnings.filterwarnings("ignore", category=EncodingWarning)
warnings.filterwarnings("error", category=EncodingWarning, module=r"(kflearn|__main__)(\.|$)")
