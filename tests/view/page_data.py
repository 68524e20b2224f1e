"""Runs in the form that the page reads (scenarios/view/page/data.js undoes it), and pages made of them."""

import base64
import json
import math
import pathlib
import random
import zlib

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "scenarios" / "view" / "page"


def quantised(low, high, count, value):
    """A value in [low, high] as one of `count` steps."""
    return min(count, max(0, round((value - low) / (high - low) * count))) if high > low else 0


def encoded(frames, bits, differences):
    """frames: lists of components, each a list of whole numbers, one per body."""
    most, out = (1 << bits) - 1, bytearray()
    zero = [[0] * len(component) for component in frames[0]]
    before, earlier = zero, zero
    for frame in frames:
        for now, last, first in zip(frame, before, earlier):
            if differences == 2:
                change = [(q - 2 * p + o) & most for q, p, o in zip(now, last, first)]
            else:
                change = [(q - p) & most for q, p in zip(now, last)]
            out += bytes(q & 255 for q in change)
            if bits == 16:
                out += bytes(q >> 8 for q in change)
        before, earlier = frame, before if differences == 2 else earlier
    return bytes(out)


def packed(data):
    return base64.b64encode(zlib.compress(data, 1)).decode()


def run(times, positions, radius=0.0, orientations=None, columns=(), **header):
    """positions: for each frame a list of (x, y, z); orientations alike, of (w, x, y, z); columns: (name, unit, values)
    with the values for each frame. Returns (header, data)."""
    flat = list(zip(*(p for frame in positions for p in frame)))
    low, high = [min(axis) for axis in flat], [max(axis) for axis in flat]
    bodies = len(positions[0])
    names = [{"name": "position", "components": 3, "bits": 16, "differences": 2}]

    def place(p):  # the last three values are those of nobody
        q = [quantised(low[k], high[k], 65535, p[k]) for k in range(3)]
        return q[:2] + [65534] if q == [65535] * 3 else q

    data = encoded([list(zip(*(place(p) for p in frame))) for frame in positions], 16, 2)
    if orientations:
        names.append({"name": "orientation", "components": 3, "bits": 16, "differences": 2})
        upper = [[[-v for v in q] if q[0] < 0 else q for q in frame] for frame in orientations]
        data += encoded([[[quantised(-1, 1, 65535, q[k]) for q in frame] for k in (1, 2, 3)] for frame in upper],
                        16, 2)
    for name, unit, values in columns:
        count = name == "contacts"
        least, most = (0, 255) if count else (min(map(min, values)), max(map(max, values)))
        names.append({"name": name, "components": 1, "bits": 8, "differences": 1, "min": least, "max": most,
                      "unit": unit})
        data += encoded([[[v if count else quantised(least, most, 255, v) for v in frame]] for frame in values], 8, 1)
    return {"format": 1, "scenario": "test", "label": "rk4, step 0.001 s", "doc": "", "bodies": bodies,
            "shown": bodies, "stride": 1, "times": times, "boundaries": [], "series": [], "notes": [],
            "groups": [{"name": "all", "first": 0, "count": bodies, "radius": radius,
                        "turns": bool(orientations)}],
            "box": {"min": low, "max": high}, "columns": names, **header}, packed(data)


def page(runs, title="test"):
    """The page of some runs, each (header, data)."""
    read = lambda name: (FOLDER / name).read_text()
    data = "\n".join(f'<script type="text/plain" id="data-{i}">{text}</script>' for i, (_, text) in enumerate(runs))
    parts = {"{{title}}": title, "{{css}}": read("view.css"),
             "{{runs}}": json.dumps([header for header, _ in runs]).replace("<", "\\u003c"), "{{data}}": data,
             "{{bundle}}": read("view.bundle.js")}
    rest, out = read("template.html"), ""
    for mark, text in parts.items():  # in the template's order: what is put in is never searched
        before, rest = rest.split(mark, 1)
        out += before + text
    return out + rest


def turn(angle, axis):
    return [math.cos(angle / 2), *(math.sin(angle / 2) * a for a in axis)]


def orbits(label="rk4, step 0.001 s", drift=0.0, frames=200, duration=4.0):
    """Three points around a centre, as inner planets; with drift they spiral out, as Euler's method lets them."""
    times = [duration * f / (frames - 1) for f in range(frames)]
    sizes = [0.5, 1.0, 1.6]
    positions, speeds = [], []
    for t in times:
        grown = [r * (1 + drift * t) for r in sizes]
        angles = [2 * math.pi * t / r ** 1.5 + k for k, r in enumerate(grown)]
        positions.append([(0, 0, 0)] + [(r * math.cos(a), r * math.sin(a), 0.3 * k * math.sin(a))
                                        for k, (r, a) in enumerate(zip(grown, angles))])
        speeds.append([0.0] + [2 * math.pi / math.sqrt(r) for r in grown])
    energy = [-19.739 * (1 - 0.1 * drift * t * (1 + 0.1 * math.sin(9 * t))) for t in times]
    return run(times, positions, columns=[("speed", "m/s", speeds)], scenario="orbits", label=label,
               doc="Three points around a fixed one.", groups=[
                   {"name": "sun", "first": 0, "count": 1, "radius": 0.12, "turns": False},
                   {"name": "planets", "first": 1, "count": 3, "radius": 0.035, "turns": False}],
               series=[{"name": "energy", "unit": "J", "values": energy},
                       {"name": "momentum", "unit": "kg m/s", "values": [0.3 + 1e-9 * math.sin(t) for t in times]}],
               notes=["positions are rounded to 0.05 mm, 1/65535 of the box"])


def spinning(frames=120, duration=2.0):
    """Balls that roll over a floor between walls, one that hovers and spins, and one at rest."""
    times = [duration * f / (frames - 1) for f in range(frames)]
    radius = 0.1
    positions, orientations, contacts, speeds = [], [], [], []
    for t in times:
        rolled = [v * t for v in (0.3, 0.5, 0.7, 0.9, 1.1, 1.3)]
        positions.append([(-1 + x, 0.3 * k - 0.7, radius) for k, x in enumerate(rolled)]
                         + [(0.2, 0.0, 0.62), (0.8, -0.8, radius)])
        orientations.append([turn(x / radius, (0, 1, 0)) for x in rolled]
                            + [turn(7 * t, (0.6, 0, 0.8)), turn(1, (1, 0, 0))])
        contacts.append([1 + (k + int(3 * t)) % 3 for k in range(6)] + [0, 1])
        speeds.append([x / t if t else 0.8 for x in rolled] + [0.0, 0.0])
    return run(times, positions, radius, orientations, [("speed", "m/s", speeds), ("contacts", "", contacts)],
               scenario="rolling", doc="Balls that roll, one that spins, one at rest.",
               boundaries=[{"shape": "plane", "point": [0, 0, 0], "normal": [0, 0, 1]},
                           {"shape": "box", "min": [-1.2, -1, 0], "max": [1.2, 1, 0.8], "open": ["-z", "+z"]}],
               groups=[{"name": "rolling", "first": 0, "count": 6, "radius": radius, "turns": True},
                       {"name": "others", "first": 6, "count": 2, "radius": [0.2, 0.1], "turns": True}],
               series=[{"name": "kinetic energy", "unit": "J", "values": [2 + math.cos(5 * t) for t in times]},
                       {"name": "contacts", "unit": "", "values": [sum(c) for c in contacts]},
                       {"name": "penetration", "unit": "m", "values": [1e-5 * abs(math.sin(20 * t)) for t in times]}])


def wandering(bodies, frames, radius=0.01, scalars=True, seed=1):
    """Many balls whose second differences are small and random, as they come from a crowd: made as bytes at once."""
    source = random.Random(seed)
    small = bytes((i % 5 - 2) & 255 for i in range(256))
    high = bytes(255 if i >= 128 else 0 for i in range(256))

    def change():
        low = source.randbytes(bodies).translate(small)
        return low + low.translate(high)

    start = [source.randbytes(2 * bodies) for _ in range(3)]
    data = bytearray()
    for frame in range(frames):
        if frame < 2:  # twice the same: at rest. q0, then q0 - 2 q0 = -q0
            for both in start:
                values = list(zip(both[:bodies], both[bodies:]))
                if frame:
                    values = [divmod(-(a + 256 * b) & 65535, 256)[::-1] for a, b in values]
                data += bytes(a for a, _ in values) + bytes(b for _, b in values)
        else:
            for _ in range(3):
                data += change()
    columns = [{"name": "position", "components": 3, "bits": 16, "differences": 2}]
    if scalars:
        columns.append({"name": "speed", "components": 1, "bits": 8, "differences": 1, "min": 0, "max": 3.2,
                        "unit": "m/s"})
        for frame in range(frames):
            data += source.randbytes(bodies) if frame == 0 else source.randbytes(bodies).translate(small)
    box = {"min": [-2, -2, 0], "max": [2, 2, 2]}
    times = [0.02 * f for f in range(frames)]
    return {"format": 1, "scenario": "crowd", "label": "rk4, step 0.001 s", "doc": "", "bodies": bodies,
            "shown": bodies, "stride": 1, "times": times, "box": box, "columns": columns,
            "groups": [{"name": "balls", "first": 0, "count": bodies, "radius": radius, "turns": False}],
            "boundaries": [{"shape": "box", **box}], "notes": [],
            "series": [{"name": "energy", "unit": "J", "values": [1 + 0.01 * math.sin(t) for t in times]}],
            }, packed(bytes(data))
