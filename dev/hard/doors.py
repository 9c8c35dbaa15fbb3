"""Where processes wait for others, and whether an answer lets a stranger in."""

from contextlib import suppress

import psutil

LOOPBACK = ("127.", "::1")


def waiting(processes):
    """The ends (ip, port) at which processes wait for others."""
    found = []
    for each in processes:
        with suppress(psutil.NoSuchProcess):
            found += [one.laddr for one in each.net_connections() if one.status == psutil.CONN_LISTEN]
    return found


def listeners(process):
    """The addresses at which a process and those that it started wait for others."""
    return [end.ip for end in waiting([process, *process.children(recursive=True)])]


def elsewhere(addresses):
    return [address for address in addresses if not address.startswith(LOOPBACK)]


def refused(status):
    """Not allowed, or not there for you."""
    return status in (401, 403, 404)
