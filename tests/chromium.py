"""Chromium as a reader uses it: real keys, its accessibility tree, its console, what it asks for."""

from __future__ import annotations

import json
import os
import select
import shutil
import subprocess
from pathlib import Path
from types import TracebackType
from typing import Any

import pytest


def _starts(name: str) -> bool:
    """Some systems have a command of this name that only says where to get the browser."""
    if shutil.which(name) is None:
        return False
    done = subprocess.run([name, "--version"], stdin=subprocess.DEVNULL, capture_output=True, check=False)
    return done.returncode == 0


BROWSER = next((name for name in ("chromium", "chromium-headless-shell", "google-chrome") if _starts(name)), None)
needs_browser = pytest.mark.skipif(BROWSER is None, reason="no Chromium: apt-get install chromium")
SILENCE = 300
"""Seconds without a word after which the browser counts as hanging."""
KEYS = {"Tab": 9, "Enter": 13, "Escape": 27, "ArrowUp": 38, "ArrowDown": 40}
LISTENED = ("Page", "Runtime", "Log", "Network", "Accessibility")
SAID = ("Runtime.consoleAPICalled", "Runtime.exceptionThrown", "Log.entryAdded")


class Chromium:
    """One page of a headless browser, driven by the DevTools protocol over a pair of pipes."""

    def __init__(self, folder: Path) -> None:
        theirs_in, self._out = os.pipe()
        self._in, theirs_out = os.pipe()
        command = [
            str(BROWSER), "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
            "--remote-debugging-pipe", f"--user-data-dir={folder / 'browser'}", "about:blank",
        ]  # fmt: skip
        # the protocol is spoken on descriptors 3 and 4, to which a shell moves the pipes
        script = f'exec "$@" 3<&{theirs_in} 4>&{theirs_out}'
        self._process = subprocess.Popen(
            ["bash", "-c", script, "chromium", *command],
            env={**os.environ, "HOME": str(folder)},
            pass_fds=(theirs_in, theirs_out),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(theirs_in)
        os.close(theirs_out)
        self._rest, self._count, self._session = b"", 0, ""
        self.events: list[dict[str, Any]] = []
        targets = self.call("Target.getTargets")["targetInfos"]
        page = next(target["targetId"] for target in targets if target["type"] == "page")
        self._session = self.call("Target.attachToTarget", targetId=page, flatten=True)["sessionId"]
        for domain in LISTENED:
            self.call(f"{domain}.enable")

    def __enter__(self) -> Chromium:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._process.terminate()
        self._process.wait(timeout=30)
        os.close(self._in)
        os.close(self._out)

    def _next(self) -> dict[str, Any]:
        while b"\0" not in self._rest:
            heard, _, _ = select.select([self._in], [], [], SILENCE)
            more = os.read(self._in, 1 << 20) if heard else b""
            if not more:
                message = "Chromium has closed its pipe" if heard else f"Chromium says nothing for {SILENCE} s"
                raise EOFError(message)
            self._rest += more
        first, _, self._rest = self._rest.partition(b"\0")
        found: dict[str, Any] = json.loads(first)
        return found

    def call(self, method: str, **parameters: Any) -> dict[str, Any]:
        """The result of a method of the protocol; the events until then are kept."""
        self._count += 1
        session = {"sessionId": self._session} if self._session else {}
        request = {"id": self._count, "method": method, "params": parameters, **session}
        os.write(self._out, json.dumps(request).encode() + b"\0")
        while (answer := self._next()).get("id") != self._count:
            self.events.append(answer)
        assert "error" not in answer, (method, answer)
        result: dict[str, Any] = answer["result"]
        return result

    def open(self, address: str, width: int = 1280) -> None:
        """Load a page at a width in pixels."""
        self.call(
            "Emulation.setDeviceMetricsOverride", width=width, height=800, deviceScaleFactor=1, mobile=width < 600
        )
        self.events.clear()
        self.call("Page.navigate", url=address)
        self.loaded()

    def loaded(self) -> None:
        while not any(event["method"] == "Page.loadEventFired" for event in self.events):
            self.events.append(self._next())

    def value(self, expression: str) -> Any:
        """The value of an expression in the page."""
        found = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in found, (expression, found)
        return found["result"].get("value")

    def press(self, *keys: str) -> None:
        for key in keys:
            text = {"Enter": "\r"}.get(key, key if len(key) == 1 else "")
            code = KEYS.get(key) or (ord(key.upper()) if key.isalnum() else 0)
            self.call("Input.dispatchKeyEvent", type="keyDown", key=key, windowsVirtualKeyCode=code, text=text)
            self.call("Input.dispatchKeyEvent", type="keyUp", key=key, windowsVirtualKeyCode=code)

    def tree(self) -> list[tuple[str, str]]:
        """Role and name of everything a screen reader meets."""
        nodes = self.call("Accessibility.getFullAXTree")["nodes"]
        shown = [node for node in nodes if not node["ignored"]]
        return [(node["role"]["value"], node.get("name", {}).get("value", "")) for node in shown]

    def said(self) -> list[dict[str, Any]]:
        """Messages of the console."""
        return [event for event in self.events if event["method"] in SAID]

    def asked(self) -> set[str]:
        """Schemes of everything that was asked for."""
        sent = [event["params"] for event in self.events if event["method"] == "Network.requestWillBeSent"]
        return {one["request"]["url"].partition(":")[0] for one in sent}
