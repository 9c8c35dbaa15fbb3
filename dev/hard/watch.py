"""What a lesson's kernel does that a lesson has no business to do. This file runs as the lesson's first cell.

An audit hook of Python tells of each process that is started, each socket, each object that is unpickled, whoever does
it; and of text that becomes code, where a lesson or kflearn does that itself (IPython and dataclasses do it always).
"""


def watch(root):
    """Start watching; returns the list that fills."""
    import sys

    seen = []
    processes = "subprocess.Popen", "os.system", "os.exec", "os.posix_spawn", "os.spawn", "os.fork", "pty.spawn"
    addresses = {"socket.connect": 1, "socket.bind": 1, "socket.sendto": 1, "socket.getaddrinfo": 0}

    def ours(frame):
        """Is it a cell of the lesson, or kflearn?"""
        name = frame.f_code.co_filename
        return "ipykernel_" in name or name.startswith(f"{root}/kflearn")

    def hook(event, details):
        if event in processes or event == "pickle.find_class":
            seen.append((event, str(details)[:80]))
        elif event in addresses:
            address = details[addresses[event]]
            host = address[0] if isinstance(address, tuple) else address  # a name of a file: a socket of this machine
            if not str(host).startswith(("127.", "::1", "localhost", "/")):
                seen.append((event, str(host)))
        elif event in ("exec", "compile") and ours(sys._getframe(1)):
            seen.append((event, str(details)[:80]))

    sys.addaudithook(hook)
    return seen


def listening():
    """Addresses other than loopback on which this process waits for others."""
    import psutil

    waits = [each.laddr.ip for each in psutil.Process().net_connections() if each.status == psutil.CONN_LISTEN]
    return [("listens", address) for address in waits if not address.startswith("127.") and address != "::1"]
