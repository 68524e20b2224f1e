"""A headless Chromium, spoken to over a pipe (--remote-debugging-pipe): the standard library is enough."""

import base64
import json
import os
import shutil
import struct
import subprocess
import tempfile
import time
import zlib

NAMES = ["chromium", "chromium-browser", "google-chrome", "chrome"]
# Drawn by the processor: no graphics card is needed, and none makes a difference.
OPTIONS = ["--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
           "--disable-dev-shm-usage", "--no-first-run", "--hide-scrollbars", "--disable-extensions",
           "--disable-background-networking", "--disable-component-update", "--remote-debugging-pipe"]


def program():
    """The browser's path, or None."""
    return next((path for path in map(shutil.which, NAMES) if path), None)


class Browser:
    def __init__(self, width=1200, height=900):
        self.profile = tempfile.mkdtemp(prefix="ballpark-view-")
        to_read, self.to = os.pipe()
        self.back, from_write = os.pipe()

        def at_3_and_4():  # where the browser looks for its pipe; two steps, since either may be in the other's place
            high = [os.dup2(fd, fd + 100) for fd in (to_read, from_write)]
            os.dup2(high[0], 3)
            os.dup2(high[1], 4)

        self.process = subprocess.Popen(
            [program(), *OPTIONS, f"--user-data-dir={self.profile}", f"--window-size={width},{height}", "about:blank"],
            preexec_fn=at_3_and_4, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_read)
        os.close(from_write)
        self.rest, self.last, self.events = b"", 0, []
        self.session = None
        target = self.call("Target.getTargets")["targetInfos"]
        page = next(info for info in target if info["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=page["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Network", "Runtime", "Log"):
            self.call(f"{domain}.enable")
        self.size(width, height)

    def close(self):
        self.session = None
        try:
            self.call("Browser.close")
        except OSError:
            pass
        self.process.wait(20)
        shutil.rmtree(self.profile, ignore_errors=True)

    def message(self, limit):
        while b"\0" not in self.rest:
            if time.monotonic() > limit:
                raise TimeoutError("the browser gave no answer")
            got = os.read(self.back, 1 << 20)
            if not got:
                raise OSError("the browser has ended")
            self.rest += got
        line, self.rest = self.rest.split(b"\0", 1)
        return json.loads(line)

    def call(self, method, **parameters):
        self.last += 1
        request = {"id": self.last, "method": method, "params": parameters}
        if self.session:
            request["sessionId"] = self.session
        data = json.dumps(request).encode() + b"\0"
        while data:
            data = data[os.write(self.to, data):]
        limit = time.monotonic() + 120
        while True:
            answer = self.message(limit)
            if answer.get("id") == self.last:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]
            if "method" in answer:
                self.events.append(answer)

    def size(self, width, height, scale=1):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=scale,
                  mobile=False)

    def evaluate(self, expression):
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(f"{expression}: {result['exceptionDetails']}")
        return result["result"].get("value")

    def open(self, path, fragment="", script="", limit=60):
        """Opens a file and waits until it has drawn or failed; a script runs before the page's own."""
        self.events.clear()
        self.call("Page.navigate", url="about:blank")
        identifier = self.call("Page.addScriptToEvaluateOnNewDocument", source=script)["identifier"] if script else None
        self.call("Page.navigate", url=f"file://{path}{'#' + fragment if fragment else ''}")
        self.wait("[document.documentElement?.dataset].some((d) => d?.drawn || d?.failed)", limit)
        if identifier:
            self.call("Page.removeScriptToEvaluateOnNewDocument", identifier=identifier)

    def wait(self, expression, limit=60):
        end = time.monotonic() + limit
        while not (value := self.evaluate(expression)):
            if time.monotonic() > end:
                raise TimeoutError(f"not so after {limit} s: {expression}")
            time.sleep(0.02)
        return value

    def key(self, key, text=None):
        self.call("Input.dispatchKeyEvent", type="keyDown", key=key, **({"text": text} if text else {}))
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key)

    def mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def requests(self):
        """Addresses asked for since the page was opened, but for the page itself."""
        self.evaluate("0")
        urls = [event["params"]["request"]["url"] for event in self.events
                if event["method"] == "Network.requestWillBeSent"]
        return [url for url in urls if not url.startswith(("file://", "about:"))]

    def errors(self):
        return [event["params"] for event in self.events
                if event["method"] == "Runtime.exceptionThrown"
                or event["method"] == "Log.entryAdded" and event["params"]["entry"]["level"] == "error"
                or event["method"] == "Runtime.consoleAPICalled" and event["params"]["type"] in ("error", "warning")]

    def picture(self, selector=None, path=None):
        """PNG bytes of the window, or of one element."""
        parameters = {}
        if selector:
            box = self.evaluate(f"(({{x, y, width, height}}) => ({{x, y, width, height}}))"
                                f"(document.querySelector({json.dumps(selector)}).getBoundingClientRect())")
            parameters["clip"] = {**box, "scale": 1}
        data = base64.b64decode(self.call("Page.captureScreenshot", format="png", **parameters)["data"])
        if path:
            with open(path, "wb") as file:
                file.write(data)
        return data


def pixels(png):
    """(width, height, rows of RGB or RGBA bytes, bytes of a pixel) of an 8-bit PNG."""
    at, packed, width, height, channels = 8, b"", 0, 0, 0
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        body = png[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, _, colour = struct.unpack(">IIBB", body[:10])
            channels = {2: 3, 6: 4}[colour]
        elif kind == b"IDAT":
            packed += body
        at += 12 + length
    raw, size = zlib.decompress(packed), width * channels
    rows, above = [], bytes(size)
    for row in range(height):
        line = bytearray(raw[row * (size + 1) + 1:(row + 1) * (size + 1)])
        unfilter(raw[row * (size + 1)], line, above, channels)
        rows.append(bytes(line))
        above = line
    return width, height, rows, channels


def unfilter(kind, line, above, channels):
    for i in range(len(line) if kind else 0):
        left = line[i - channels] if i >= channels else 0
        if kind == 1:
            guess = left
        elif kind == 2:
            guess = above[i]
        elif kind == 3:
            guess = (left + above[i]) // 2
        else:
            corner = above[i - channels] if i >= channels else 0
            guess = min((left, above[i], corner), key=lambda v, p=left + above[i] - corner: abs(p - v))
        line[i] = (line[i] + guess) & 255
