"""A channel server that misbehaves on purpose. Loopback only; it ends with the test that started it.

Files come from a folder. What is wrong with an answer is said by a plan: path -> list of faults, one for each
request of it in turn; when the list is used up, the file is given as it should be (a last fault of `...` repeats for
ever).
"""
from __future__ import annotations

import email.utils
import hashlib
import http.server
import socket
import ssl
import struct
import subprocess
import threading
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any


@dataclass(frozen=True)
class Fault:
    """`kind`: see the methods of Handler named so."""

    kind: str
    value: Any = None


FOREVER = Fault("forever")


@dataclass(frozen=True)
class Seen:
    path: str
    status: int
    headers: dict[str, str]
    at: float  # seconds of time.monotonic()


@dataclass
class Behaviour:
    folder: Path
    plan: dict[str, list[Fault]] = field(default_factory=dict)
    seen: list[Seen] = field(default_factory=list)
    stop: threading.Event = field(default_factory=threading.Event)
    lock: threading.Lock = field(default_factory=threading.Lock)
    etags: bool = True
    connections: int = 0
    most_connections: int = 0  # at once

    def next_fault(self, path: str) -> Fault | None:
        with self.lock:
            faults = self.plan.get(path, [])
            if not faults:
                return None
            if len(faults) > 1 and faults[1] is FOREVER:
                return faults[0]
            return faults.pop(0)


class Handler(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    behaviour: Behaviour

    def setup(self) -> None:
        super().setup()
        with self.behaviour.lock:
            self.behaviour.connections += 1
            self.behaviour.most_connections = max(self.behaviour.most_connections, self.behaviour.connections)

    def log_message(self, format: str, *args: Any) -> None:  # noqa: A002 (the name is the base class's)
        pass

    def note(self, status: int) -> None:
        headers = {name.lower(): value for name, value in self.headers.items()}
        with self.behaviour.lock:
            self.behaviour.seen.append(Seen(self.path, status, headers, time.monotonic()))

    def do_GET(self) -> None:
        path = self.path.split("?")[0]
        if path.startswith("http://"):  # asked as a proxy
            path = "/" + path.split("/", 3)[3]
        fault = self.behaviour.next_fault(path)
        file = self.behaviour.folder / path.lstrip("/")
        body = file.read_bytes() if file.is_file() else None
        if fault is not None:
            getattr(self, fault.kind)(fault.value, body if body is not None else b"")
        elif body is None:
            self.plain(404, b"not here")
        else:
            self.give(body)

    def plain(self, status: int, body: bytes, headers: dict[str, str] | None = None) -> None:
        self.note(status)
        self.send_response(status)
        self.send_header("Content-Length", str(len(body)))
        for name, value in (headers or {}).items():
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(body)

    def give(self, body: bytes) -> None:
        etag = '"' + hashlib.sha256(body).hexdigest()[:20] + '"'
        headers = {"ETag": etag} if self.behaviour.etags else {
            "Last-Modified": email.utils.formatdate(1_700_000_000, usegmt=True)}
        if self.headers.get("If-None-Match") == etag or (
                not self.behaviour.etags and self.headers.get("If-Modified-Since")):
            self.note(304)
            self.send_response(304)
            self.end_headers()
            return
        wanted = self.headers.get("Range", "")
        if wanted.startswith("bytes=") and wanted.endswith("-"):
            begin = int(wanted[6:-1])
            if begin >= len(body):
                self.plain(416, b"")
                return
            headers["Content-Range"] = f"bytes {begin}-{len(body) - 1}/{len(body)}"
            self.plain(206, body[begin:], headers)
            return
        self.plain(200, body, headers)

    # The faults.

    def together(self, barrier: threading.Barrier, body: bytes) -> None:
        """Nobody is answered before as many have asked as the barrier is for."""
        try:
            barrier.wait()
        except threading.BrokenBarrierError:
            self.plain(503, b"nobody else came")
        else:
            self.give(body)

    def truncate(self, keep: int, body: bytes) -> None:
        """Promises all, gives the first `keep` bytes (of what is asked for), ends the connection."""
        wanted = self.headers.get("Range", "")
        begin = int(wanted[6:-1]) if wanted.startswith("bytes=") else 0
        rest = body[begin:]
        self.note(206 if begin else 200)
        self.send_response(206 if begin else 200)
        self.send_header("Content-Length", str(len(rest)))
        if begin:
            self.send_header("Content-Range", f"bytes {begin}-{len(body) - 1}/{len(body)}")
        self.end_headers()
        self.wfile.write(rest[:keep])
        self.close_connection = True

    def truncate_without_ranges(self, keep: int, body: bytes) -> None:
        """The same from a server that knows no ranges."""
        self.note(200)
        self.send_response(200)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body[:keep])
        self.close_connection = True

    def whole_despite_range(self, _: object, body: bytes) -> None:
        self.plain(200, body)

    def wrong_range(self, _: object, body: bytes) -> None:
        """Answers a request for the end with the beginning."""
        if "Range" not in self.headers:
            self.plain(200, body)
            return
        self.plain(206, body[:-1], {"Content-Range": f"bytes 0-{len(body) - 2}/{len(body)}"})

    def status(self, code: int, _: bytes) -> None:
        self.plain(code, b"no")

    def retry_after(self, value: tuple[int, str], _: bytes) -> None:
        code, pause = value
        self.plain(code, b"later", {"Retry-After": pause})

    def other_bytes(self, _: object, body: bytes) -> None:
        """As many bytes as there should be, one of them wrong."""
        middle = len(body) // 2
        self.plain(200, body[:middle] + bytes([body[middle] ^ 1]) + body[middle + 1:])

    def shorter_than_real(self, cut: int, body: bytes) -> None:
        """A Content-Length that is too small, with all bytes behind it."""
        self.note(200)
        self.send_response(200)
        self.send_header("Content-Length", str(len(body) - cut))
        self.end_headers()
        self.wfile.write(body)
        self.close_connection = True

    def longer_than_real(self, more: int, body: bytes) -> None:
        """A Content-Length that is too large: the connection ends before it."""
        wanted = self.headers.get("Range", "")
        begin = int(wanted[6:-1]) if wanted.startswith("bytes=") else 0
        self.note(206 if begin else 200)
        self.send_response(206 if begin else 200)
        self.send_header("Content-Length", str(len(body) - begin + more))
        if begin:
            self.send_header("Content-Range", f"bytes {begin}-{len(body) + more - 1}/{len(body) + more}")
        self.end_headers()
        self.wfile.write(body[begin:])
        self.close_connection = True

    def login_page(self, _: object, __: bytes) -> None:
        """What stands in front of many networks: an answer, but not of the server."""
        self.plain(200, b"<!doctype html><title>Welcome</title>")

    def endless(self, _: object, body: bytes) -> None:
        """The file, and then no end of zeros."""
        self.note(200)
        self.send_response(200)
        self.end_headers()
        self.close_connection = True
        try:
            self.wfile.write(body)
            while not self.behaviour.stop.is_set():
                self.wfile.write(b"\0" * 65536)
        except OSError:
            pass  # the client has had enough, as it should

    def drip(self, _: object, body: bytes) -> None:
        """A byte now and then, until the client gives up."""
        self.note(200)
        self.send_response(200)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.close_connection = True
        try:
            for byte in body:
                self.wfile.write(bytes([byte]))
                self.wfile.flush()
                if self.behaviour.stop.wait(0.1):
                    return
        except OSError:
            pass  # the client has had enough, as it should

    def reset(self, keep: int, body: bytes) -> None:
        """Some bytes, then the connection is reset."""
        self.note(200)
        self.send_response(200)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body[:keep])
        self.wfile.flush()
        self.connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        self.connection.close()
        self.close_connection = True

    def redirect(self, place: str, _: bytes) -> None:
        self.plain(302, b"", {"Location": place})

    def finish(self) -> None:
        with self.behaviour.lock:
            self.behaviour.connections -= 1
        try:
            super().finish()
        except (OSError, ValueError):
            pass  # reset() has closed it already


class Server(http.server.ThreadingHTTPServer):
    daemon_threads = True
    request_queue_size = 128

    def handle_error(self, request: Any, client_address: Any) -> None:
        pass  # a client that went away is what these tests are about


class FaultServer:
    """Use with `with`; `url` is its address."""

    def __init__(self, folder: Path, certificate: Path | None = None) -> None:
        self.behaviour = Behaviour(folder)
        handler = type("BoundHandler", (Handler,), {"behaviour": self.behaviour})
        self._server = Server(("127.0.0.1", 0), handler)
        if certificate is not None:
            context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
            context.load_cert_chain(certificate)
            self._server.socket = context.wrap_socket(self._server.socket, server_side=True)
        scheme = "http" if certificate is None else "https"
        self.url = f"{scheme}://127.0.0.1:{self._server.server_address[1]}"
        self._thread = threading.Thread(target=self._server.serve_forever, args=(0.05,), daemon=True)

    def __enter__(self) -> FaultServer:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.behaviour.stop.set()
        self._server.shutdown()
        self._server.server_close()
        self._thread.join(10)

    def plan(self, path: str, *faults: Fault) -> None:
        self.behaviour.plan[path] = list(faults)

    def seen(self, path: str) -> list[Seen]:
        with self.behaviour.lock:
            return [one for one in self.behaviour.seen if one.path.split("?")[0] == path]

    def forget(self) -> None:
        with self.behaviour.lock:
            self.behaviour.seen.clear()


def self_signed_certificate(folder: Path) -> Path:
    """A key and a certificate for 127.0.0.1 that nobody has signed, in one PEM file."""
    pem = folder / "self-signed.pem"
    subprocess.run(
        ["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes",
         "-keyout", str(folder / "key.pem"), "-out", str(folder / "cert.pem"), "-days", "2",
         "-subj", "/CN=127.0.0.1", "-addext", "subjectAltName=IP:127.0.0.1"],
        check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    pem.write_bytes((folder / "key.pem").read_bytes() + (folder / "cert.pem").read_bytes())
    return pem
