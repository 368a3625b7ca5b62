#!/usr/bin/env python3
"""Pages in a headless Chromium, for tests and pictures; nothing but Python and Debian's package chromium.

    tools/browser.py PAGE.html -o FOLDER

leaves pictures of the page in FOLDER: 390 and 1280 pixels wide, and 1280 by night; and says its size and the time to its first paint.
"""

import argparse
import base64
import json
import os
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

PROGRAM = shutil.which("chromium")
PATIENCE = 60.0  # seconds, for any answer


class Browser:
    """Chromium's DevTools protocol through a pair of pipes: JSON, each message ended by a zero byte."""

    def __init__(self):
        self.profile = tempfile.TemporaryDirectory()
        down, self.down = os.pipe()
        self.up, up = os.pipe()
        # The protocol is spoken on descriptors 3 and 4. Containers have neither a sandbox nor a graphics card.
        words = f'exec "$0" --headless=new --no-sandbox --disable-gpu --remote-debugging-pipe --user-data-dir="$1" 3<&{down} 4>&{up}'
        self.process = subprocess.Popen(["bash", "-c", words, PROGRAM, self.profile.name], pass_fds=(down, up),
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(down)
        os.close(up)
        self.rest, self.number, self.events = b"", 0, []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.say("Browser.close")
        try:
            self.process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            self.process.kill()
        os.close(self.down)
        os.close(self.up)
        shutil.rmtree(self.profile.name, ignore_errors=True)

    def hear(self):
        """The next message."""
        os.set_blocking(self.up, False)
        end = time.monotonic() + PATIENCE
        while b"\0" not in self.rest:
            try:
                part = os.read(self.up, 1 << 20)
            except BlockingIOError:
                if time.monotonic() > end:
                    raise TimeoutError("Chromium does not answer") from None
                time.sleep(0.002)
                continue
            if not part:
                raise EOFError("Chromium has ended")
            self.rest += part
        message, self.rest = self.rest.split(b"\0", 1)
        return json.loads(message)

    def say(self, method, session=None, **parameters):
        """Sends a command and waits for its answer. What Chromium tells meanwhile is kept in `events`."""
        self.number += 1
        command = {"id": self.number, "method": method, "params": parameters, **({"sessionId": session} if session else {})}
        text = json.dumps(command).encode() + b"\0"
        while text:
            text = text[os.write(self.down, text):]
        while (message := self.hear()).get("id") != self.number:
            self.events.append(message)
        if "error" in message:
            raise RuntimeError(f"{method}: {message['error']['message']}")
        return message["result"]

    def open(self, path, width, height=900, dark=False):
        return Page(self, path, width, height, dark)


class Page:
    """A file in a window of its own. `complaints` and `requests` tell what the page has said and asked for."""

    def __init__(self, browser, path, width, height, dark):
        self.browser = browser
        self.first = len(browser.events)
        self.target = browser.say("Target.createTarget", url="about:blank")["targetId"]
        self.session = browser.say("Target.attachToTarget", targetId=self.target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.say(f"{domain}.enable")
        self.say("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 600)
        if dark:
            self.say("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark"}])
        self.say("Page.navigate", url=Path(path).resolve().as_uri())
        self.wait_for("document.readyState == 'complete' && performance.getEntriesByType('paint').length > 0")

    def say(self, method, **parameters):
        return self.browser.say(method, self.session, **parameters)

    def value(self, expression):
        found = self.say("Runtime.evaluate", expression=expression, returnByValue=True)
        if "exceptionDetails" in found:
            raise RuntimeError(f"{expression}: {found['exceptionDetails']}")
        return found["result"].get("value")

    def wait_for(self, expression):
        end = time.monotonic() + PATIENCE
        while not self.value(expression):
            if time.monotonic() > end:
                raise TimeoutError(expression)
            time.sleep(0.02)

    def press(self, key):
        for kind in ("keyDown", "keyUp"):
            self.say("Input.dispatchKeyEvent", type=kind, key=key, code=key, windowsVirtualKeyCode={"Home": 36, "End": 35, "ArrowLeft": 37, "ArrowRight": 39}[key])

    def told(self, method):
        events = self.browser.events[self.first:]
        return [event["params"] for event in events if event.get("sessionId") == self.session and event["method"] == method]

    def complaints(self):
        consoled = [entry for entry in self.told("Runtime.consoleAPICalled") if entry["type"] in ("error", "warning", "assert")]
        return self.told("Runtime.exceptionThrown") + self.told("Log.entryAdded") + consoled

    def requests(self):
        return [request["request"]["url"] for request in self.told("Network.requestWillBeSent")]

    def first_paint(self):
        """Milliseconds from the start of loading to the first content."""
        return self.value("performance.getEntriesByName('first-contentful-paint')[0].startTime")

    def picture(self, path, height):
        clip = {"x": 0, "y": 0, "width": self.value("innerWidth"), "height": height, "scale": 1}
        shot = self.say("Page.captureScreenshot", clip=clip, captureBeyondViewport=True)
        Path(path).write_bytes(base64.b64decode(shot["data"]))

    def close(self):
        self.browser.say("Target.closeTarget", targetId=self.target)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--height", type=int, default=1600, help="pixels, from the top of the page")
    options = parser.parse_args()
    folder = Path(options.output)
    folder.mkdir(parents=True, exist_ok=True)
    with Browser() as browser:
        for name, width, dark in (("390", 390, False), ("1280", 1280, False), ("dark", 1280, True)):
            page = browser.open(options.page, width, dark=dark)
            page.picture(folder / f"{Path(options.page).stem}-{name}.png", options.height)
            print(f"{name}: first paint after {page.first_paint():.0f} ms")
            page.close()
    print(f"{Path(options.page).stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    main()
