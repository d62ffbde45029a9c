"""Small channels and a ros2wasm that sees only them and a cache of its own."""
from __future__ import annotations

import bz2
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

CLI = os.path.abspath(os.environ.get("ROS2WASM_CLI", "build/ros2wasm"))
WATCHDOG_SECONDS = 120


class ChannelCase(unittest.TestCase):
    """A folder for each test; `self.channel` is a channel folder in it."""

    def setUp(self) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="ros2wasm-network-")
        self.addCleanup(self._folder.cleanup)
        self.folder = Path(self._folder.name)
        self.channel = self.folder / "channel"
        # How long a stall may be is the program's own choice: with less, a slow machine would look like a slow server.
        self.environment = {
            "PATH": os.environ["PATH"], "HOME": str(self.folder), "NO_COLOR": "1",
            "XDG_CACHE_HOME": str(self.folder / "cache"), "ROS2WASM_RETRIES": "2",
        }

    def run_cli(self, *words: str, **variables: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [CLI, *words], cwd=self.folder, env=self.environment | variables, text=True,
            capture_output=True, timeout=WATCHDOG_SECONDS, check=False)

    def succeed(self, *words: str, **variables: str) -> str:
        done = self.run_cli(*words, **variables)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def fail_with(self, code: str, *words: str, **variables: str) -> str:
        """The command must end with one clear error: this code, no bug, exit code 3 or 1."""
        done = self.run_cli(*words, **variables)
        self.assertIn(done.returncode, (1, 3), done.stdout + done.stderr)
        self.assertIn(f"error[{code}]", done.stderr)
        return done.stderr

    def add_package(self, name: str, files: dict[str, bytes], depends: list[str] | None = None,
                    version: str = "1.0", channel: Path | None = None) -> Path:
        stage = self.folder / f"stage-{name}-{version}"
        for path, content in files.items():
            (stage / path).parent.mkdir(parents=True, exist_ok=True)
            (stage / path).write_bytes(content)
        words = ["channel", "add", str(channel or self.channel), "--prefix", str(stage), "--name", name,
                 "--version", version, "--build", "h_0", "--noarch", "--license", "MIT"]
        for spec in depends or []:
            words += ["--depends", spec]
        return Path(self.succeed(*words).strip())

    def write_index(self, channel: Path | None = None) -> None:
        self.succeed("channel", "index", str(channel or self.channel))

    def locked(self, name: str) -> str:
        """What ros2wasm.lock says of a package, one line each key, without quotes."""
        text = (self.folder / "ros2wasm.lock").read_text().replace('"', "")
        return next(part for part in text.split("\n  - ") if part.startswith(f"name: {name}\n"))

    def keep_forms(self, *names: str) -> None:
        """Leaves only these forms of the index; makes the .bz2, which is old."""
        for subdir in self.channel.iterdir():
            text = (subdir / "repodata.json").read_bytes()
            if "repodata.json.bz2" in names:
                (subdir / "repodata.json.bz2").write_bytes(bz2.compress(text))
            for file in subdir.glob("repodata*"):
                if file.name not in names:
                    file.unlink()
            for file in subdir.glob("*.msgpack.zst"):
                if "repodata_shards.msgpack.zst" not in names:
                    file.unlink()

    def solution(self, channel: str, *specs: str, words: tuple[str, ...] = (), **variables: str) -> list[str]:
        """"name url" of each chosen package."""
        out = self.succeed("solve", "--json", "-c", channel, *words, *specs, **variables)
        return [f'{one["name"]} {one["url"]}' for one in json.loads(out)["packages"]]
