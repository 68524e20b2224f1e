"""The page of `ballpark view` in headless Chromium: made of its committed bundle and of data from page_data.py.
usage: page_test.py [unittest options]"""

import math
import pathlib
import shutil
import sys
import tempfile
import unittest

import page_data
from browser import Browser, pixels, program

DRAWN = "document.documentElement.dataset"
WIDTH, HEIGHT = 1000, 800


def differing(one, other):
    """The share of pixels that differ."""
    (width, height, first, size), (_, _, second, _) = pixels(one), pixels(other)
    count = sum(a[i:i + size] != b[i:i + size] for a, b in zip(first, second) for i in range(0, len(a), size))
    return count / (width * height)


def covered(picture):
    """The share of pixels that differ from the background, the most frequent colour."""
    width, height, rows, size = pixels(picture)
    count = {}
    for row in rows:
        for i in range(0, len(row), size):
            colour = row[i:i + size]
            count[colour] = count.get(colour, 0) + 1
    return 1 - max(count.values()) / (width * height)


class PageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="ballpark-page-"))
        cls.browser = Browser(WIDTH, HEIGHT)

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        shutil.rmtree(cls.folder, ignore_errors=True)

    def open(self, runs, fragment="t=0", **more):
        path = self.folder / "page.html"
        path.write_text(page_data.page(runs))
        self.browser.open(path, fragment, **more)
        return path

    def canvas(self):
        self.settle()
        return self.browser.picture("canvas")

    def settle(self):
        self.browser.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def state(self, name):
        return self.browser.evaluate(f"ballpark.state.{name}")

    def time(self):
        return float(self.browser.evaluate(f"{DRAWN}.time"))

    def seen_at(self, point):
        """The pixel at which a point of space is drawn in the only view, and what the canvas shows there."""
        x, y = self.browser.evaluate(f"""(() => {{
          const {{ camera, canvas }} = ballpark.scene, p = camera.position.clone().set({", ".join(map(str, point))});
          camera.updateMatrixWorld();
          p.project(camera);
          return [(p.x + 1) / 2 * canvas.clientWidth, (1 - p.y) / 2 * canvas.clientHeight];
        }})()""")
        _, _, rows, size = pixels(self.canvas())
        return rows[int(y)][int(x) * size:int(x) * size + 3]

    def assert_quiet(self):
        """No request but for the page, and no error."""
        self.assertEqual(self.browser.requests(), [])
        self.assertEqual(self.browser.errors(), [])


class Picture(PageTest):
    def test_a_run_is_drawn_and_moves(self):
        self.open([page_data.orbits()], "t=1&paths=0")
        one = self.canvas()
        self.assertGreater(covered(one), 0.002)
        self.browser.evaluate("location.hash = 't=2'")
        self.browser.wait(f"{DRAWN}.time === '2'")
        self.assertGreater(differing(one, self.canvas()), 0.0005)
        self.browser.evaluate("location.hash = 't=1'")
        self.browser.wait(f"{DRAWN}.time === '1'")
        self.assertEqual(differing(one, self.canvas()), 0)
        self.assert_quiet()

    def test_values_are_what_was_packed(self):
        times = [0.0, 0.5, 1.0, 3.0]
        places = [[(math.sin(7 * t + k), 10 * t - k, k * 1e-3) for k in range(5)] for t in times]
        turns = [[page_data.turn(3 * t + k, (0, 0.6, 0.8)) for k in range(5)] for t in times]
        touching = [[(k + f) % 3 * 100 for k in range(5)] for f in range(4)]
        self.open([page_data.run(times, places, 0.1, turns, [("contacts", "", touching)])])
        columns = self.browser.evaluate(
            "Object.fromEntries(Object.entries(ballpark.runs[0].columns).map(([k, c]) => [k, [...c.values]]))")
        for f in range(4):
            for body in range(5):
                at = 5 * f + body
                for k, (low, high) in enumerate(zip(map(min, zip(*sum(places, []))), map(max, zip(*sum(places, []))))):
                    value = low + (high - low) * columns["position"][3 * at + k] / 65535
                    self.assertLessEqual(abs(value - places[f][body][k]), 0.5001 * (high - low) / 65535)
                w, *xyz = turns[f][body]
                for k in range(3):
                    value = columns["orientation"][3 * at + k] / 65535 * 2 - 1
                    self.assertLessEqual(abs(value - math.copysign(1, w) * xyz[k]), 1.001 / 65535)
                self.assertEqual(columns["contacts"][at], touching[f][body])

    def test_bodies_are_drawn_where_they_are_between_frames_too(self):
        places = [[(-1.0, 0, 0), (1.0, 0.5, 0.5)], [(1.0, 0, 0), (1.0, 0.5, 0.5)]]
        self.open([page_data.run([0.0, 1.0], places, 0.1)], "t=0.25&paths=0&look=-90,0")
        background = self.seen_at((0.5, 0, 0))
        self.assertNotEqual(self.seen_at((-0.5, 0, 0)), background)
        for empty in ((-1, 0, 0), (-0.38, 0, 0), (-0.62, 0, 0), (1, 0, 0)):
            self.assertEqual(self.seen_at(empty), background, empty)
        for full in ((-0.42, 0, 0), (-0.58, 0, 0), (1, 0.5, 0.5)):
            self.assertNotEqual(self.seen_at(full), background, full)

    def test_where_space_repeats_a_body_goes_the_short_way(self):
        places = [[(0.9, 0, 0), (0, 0.3, 0)], [(-0.9, 0, 0), (0, 0.3, 0)]]
        self.open([page_data.run([0.0, 1.0], places, 0.1, boundaries=[
            {"shape": "periodic", "point": [0, 0, 0], "size": [2, 0, 0]}])], "t=0.25&paths=0&boundaries=0")
        self.assertNotEqual(self.seen_at((0.95, 0, 0)), self.seen_at((0.45, 0, 0)))

    def test_nearer_balls_hide_others_to_the_depth_of_their_surface(self):
        # seen from -x, the small ball's front is before that of the large one, whose centre is nearer
        places = [[(0.0, 0, 0), (-0.85, 0, 0)]] * 2
        groups = [{"name": n, "first": i, "count": 1, "radius": r} for i, (n, r) in enumerate([("a", 1), ("b", 0.2)])]
        self.open([page_data.run([0.0, 1.0], places, groups=groups)], "t=0&colour=group&look=180,0&paths=0")
        self.assertNotEqual(*(max(range(3), key=lambda i, p=self.seen_at(p): p[i]) for p in
                              ((-1.05, 0, 0.0), (-0.9, 0, 0.4))))

    def test_stripes_show_that_a_ball_turns_in_its_place(self):
        times = [0.0, 1.0]
        turns = [[page_data.turn(0, (1, 0, 0))], [page_data.turn(1, (1, 0, 0))]]
        runs = [page_data.run(times, [[(0, 0, 0)]] * 2, 0.5, turns)]
        for stripes, least, most in (("1", 0.01, 1), ("0", 0, 0)):
            shown = []
            for t in times:
                self.open(runs, f"t={t}&stripes={stripes}")
                shown.append(self.canvas())
            self.assertGreaterEqual(differing(*shown), least)
            self.assertLessEqual(differing(*shown), most)

    def test_axes_show_that_a_point_turns(self):
        turns = [[page_data.turn(a, (0.6, 0, 0.8))] for a in (0, 1)]
        shown = []
        for t in (0, 1):
            self.open([page_data.run([0.0, 1.0], [[(0, 0, 0)]] * 2, 0, turns)], f"t={t}")
            shown.append(self.canvas())
        self.assertGreater(differing(*shown), 0.002)

    def test_colours_differ_and_have_a_legend(self):
        self.open([page_data.spinning()], "t=0.5&colour=speed")
        self.assertIn("speed [m/s]", self.browser.evaluate("document.querySelector('.legend').innerText"))
        shown = {"speed": self.canvas()}
        for expected in ("contacts", "group", "plain"):
            self.browser.key("c", "c")
            self.assertEqual(self.state("colour"), expected)
            shown[expected] = self.canvas()
            self.assertEqual(self.browser.evaluate("document.querySelector('.legend').hidden"), expected == "plain")
        names = list(shown)
        for i, one in enumerate(names):
            for other in names[:i]:
                self.assertGreater(differing(shown[one], shown[other]), 0.003, (one, other))

    def test_boundaries_are_drawn_and_can_be_left_out(self):
        tube = {"shape": "tube", "point": [0, 0, 0], "normal": [0, 0, 1], "radius": 1.1}
        self.open([page_data.spinning()], "t=0.5")
        with_them = self.canvas()
        self.browser.key("b", "b")
        without = self.canvas()
        self.assertGreater(differing(with_them, without), 0.01)
        self.open([page_data.run([0.0], [[(0, 0, 0), (0, 0, 1)]], 0.1, boundaries=[tube])])
        self.assertGreater(covered(self.canvas()), 0.02)
        self.assert_quiet()

    def test_crowds_are_drawn(self):
        self.open([page_data.wandering(100_000, 3, 0.008)])
        self.assertGreater(covered(self.canvas()), 0.1)
        self.assert_quiet()

    def test_where_drawing_is_slow_a_share_of_a_crowd_moves(self):
        self.open([page_data.wandering(6_000, 3, 0.012, scalars=False)], "t=0&boundaries=0")
        whole = self.canvas()
        self.browser.evaluate("for (let i = 0; i < 12; ++i) ballpark.pace.note(0.2)")
        self.assertEqual(self.browser.evaluate("ballpark.pace.share"), 0.25)
        self.browser.evaluate("ballpark.pace.note = () => {}; ballpark.set({ playing: true, rate: 1e-9 })")
        self.assertLess(covered(self.canvas()), 0.7 * covered(whole))
        self.assertEqual(self.browser.evaluate("ballpark.scene.parts[0].balls.geometry.drawRange.count"), 1500)
        self.assertIn("1 of 4 bodies", self.browser.evaluate("document.querySelector('.thinned').innerText"))
        self.browser.evaluate("ballpark.set({ playing: false, time: 0 })")
        self.assertEqual(differing(whole, self.canvas()), 0)

    def test_a_large_run_opens_quickly(self):
        path = self.open([page_data.wandering(10_000, 300, 0.025, scalars=False)], limit=120)
        self.assertLess(path.stat().st_size, 20e6)
        times = []
        for _ in range(3):
            self.browser.open(path, "t=1")
            times.append(int(self.browser.evaluate(f"{DRAWN}.drawn")))
        print(f"10,000 bodies x 300 frames, {path.stat().st_size / 1e6:.1f} MB: drawn after {sorted(times)} ms",
              file=sys.stderr)
        if CHECK_TIMES:
            self.assertLess(min(times), 2000)


class Playing(PageTest):
    def test_space_plays_and_pauses(self):
        self.open([page_data.orbits()], "t=0&speed=1&loop=0")
        self.browser.key(" ", " ")
        self.browser.wait(f"{DRAWN}.time > 0.1")
        self.browser.key(" ", " ")
        self.settle()
        held = self.time()
        self.settle()
        self.assertEqual(self.time(), held)
        self.assertFalse(self.state("playing"))

    def test_a_run_ends_or_begins_again(self):
        self.open([page_data.orbits()], "t=3.9&speed=4&loop=0&play=1")
        self.browser.wait("!ballpark.state.playing")
        self.settle()
        self.assertEqual(self.time(), 4)
        self.open([page_data.orbits()], "t=3.9&speed=4&loop=1&play=1")
        self.browser.wait(f"{DRAWN}.time < 3")
        self.assertTrue(self.state("playing"))

    def test_it_plays_by_itself_in_about_ten_seconds(self):
        for duration, rate in ((4.0, 0.5), (10.0, 1), (3e6, 3e5), (1e-4, 1e-5)):
            self.open([page_data.orbits(duration=duration, frames=5)], "")
            self.assertTrue(self.state("playing"))
            self.assertLess(abs(math.log(self.state("rate") / rate)), math.log(3.5), duration)

    def test_frames_are_stepped_through(self):
        times = [0.0, 0.1, 0.5, 2.0]
        self.open([page_data.run(times, [[(t, 0, 0)] for t in times])], "t=0.2")
        for key, expected in (("ArrowRight", 0.5), ("ArrowRight", 2), ("ArrowRight", 2), ("ArrowLeft", 0.5),
                              ("ArrowLeft", 0.1), ("Home", 0), ("ArrowLeft", 0), ("End", 2)):
            self.browser.key(key)
            self.settle()
            self.assertEqual(self.time(), expected, key)

    def test_the_slider_and_the_plots_set_the_time(self):
        self.open([page_data.orbits()], "t=0")
        self.browser.evaluate("""(() => { const s = document.querySelector("input[type=range]");
          s.value = 0.25; s.dispatchEvent(new Event("input")); })()""")
        self.settle()
        self.assertAlmostEqual(self.time(), 1)
        x, y, width = self.browser.evaluate("""(() => { const s = document.querySelector(".plot svg");
          s.scrollIntoView(); const b = s.getBoundingClientRect(); return [b.x, b.y, b.width]; })()""")
        left, right = 58, 10  # the plot's margins
        at = x + left + 0.75 * (width - left - right)
        self.browser.mouse("mousePressed", at, y + 40, button="left", buttons=1, clickCount=1)
        self.browser.mouse("mouseReleased", at, y + 40, button="left")
        self.settle()
        self.assertAlmostEqual(self.time(), 3, delta=0.01)
        head = self.browser.evaluate("document.querySelector('.plot .head').getBoundingClientRect().x")
        self.assertAlmostEqual(head, at, delta=5)

    def test_speeds_are_chosen_by_keys(self):
        self.open([page_data.orbits()], "t=0")
        before = self.state("rate")
        self.browser.key("+", "+")
        self.assertEqual(self.state("rate"), 2 * before)
        self.browser.key("-", "-")
        self.browser.key("-", "-")
        self.assertEqual(self.state("rate"), before / 2)


class Comparing(PageTest):
    RUNS = [page_data.orbits("euler, step 0.01 s", 0.08), page_data.orbits(frames=90)]

    def test_runs_are_side_by_side_or_overlaid(self):
        self.open(self.RUNS, "t=2")
        self.assertEqual(self.browser.evaluate("[...document.querySelectorAll('.view-name')].map((e) => e.innerText)"),
                         ["euler, step 0.01 s", "rk4, step 0.001 s"])
        beside = self.canvas()
        self.browser.key("m", "m")
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('.view-name').length"), 0)
        self.assertIn("euler, step 0.01 s", self.browser.evaluate("document.querySelector('.legend').innerText"))
        self.assertGreater(differing(beside, self.canvas()), 0.01)
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('.plot:first-child .curve').length"), 2)
        self.assert_quiet()

    def test_they_go_in_step_by_simulated_time(self):
        """Of a steady motion by few frames and by many, uneven ones, any moment looks the same."""
        uneven = [[0.0, 1.0, 4.0], [0.0, 0.1, 0.7, 0.9, 2.0, 3.7, 4.0]]
        runs = [page_data.run(times, [[(t - k, k + 0.2 * t, k * t) for k in range(4)] for t in times], 0.2)
                for times in uneven]
        self.open(runs, "t=1.234&mode=beside&paths=0&colour=plain")
        width, _, rows, size = pixels(self.canvas())
        half = width // 2 * size
        off = sum(any(abs(a - b) > 30 for a, b in zip(row[i:i + 3], row[half + i:half + i + 3]))
                  for row in rows[60:] for i in range(size, half - size, size))
        self.assertLess(off, 40)


class Surroundings(PageTest):
    def test_light_and_dark(self):
        self.open([page_data.orbits()], "t=1&theme=light")
        light = self.canvas()
        self.browser.key("d", "d")
        self.assertGreater(differing(light, self.canvas()), 0.95)
        for scheme in ("dark", "light"):
            self.browser.call("Emulation.setEmulatedMedia",
                              features=[{"name": "prefers-color-scheme", "value": scheme}])
            self.open([page_data.orbits()])
            self.assertEqual(self.browser.evaluate(f"{DRAWN}.theme"), scheme)
        self.browser.call("Emulation.setEmulatedMedia", features=[])

    def test_a_small_window_holds_all(self):
        self.browser.size(360, 640)
        self.addCleanup(self.browser.size, WIDTH, HEIGHT)
        self.open([page_data.spinning()], "t=1")
        self.assertLessEqual(self.browser.evaluate("document.documentElement.scrollWidth"), 360)
        self.assertGreater(covered(self.canvas()), 0.01)

    def test_notes_are_shown_and_text_is_no_markup(self):
        header, data = page_data.orbits()
        header = {**header, "doc": "a <b>bold</b> run", "notes": ["every 10th of 40 bodies is shown", "</script>"]}
        self.open([(header, data)])
        text = self.browser.evaluate("document.getElementById('page').innerText")
        for words in ("a <b>bold</b> run", "every 10th of 40 bodies is shown", "</script>"):
            self.assertIn(words, text)

    def test_a_recorded_file_has_no_plots(self):
        """Neither sums of the run nor, without velocities, speeds: the motion is shown all the same."""
        places = [[(t, 0, 0), (0, t, 0)] for t in (0.0, 0.5, 1.0)]
        self.open([page_data.run([0.0, 1.0, 2.0], places, [0.1, 0.2], label="a.npz")], "t=1")
        self.assertGreater(covered(self.canvas()), 0.002)
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('.plot').length"), 0)
        self.assertEqual(self.browser.evaluate("ballpark.offer.colours"), ["plain"])
        self.assertIn("a.npz, 2 bodies", self.browser.evaluate("document.getElementById('page').innerText"))
        self.assert_quiet()

    def test_all_series_of_a_run_are_plotted(self):
        names = ["energy", "kinetic energy", "potential energy", "momentum", "angular momentum",
                 "deepest penetration so far", "contacts", "time per body-step"]
        header, data = page_data.orbits()
        series = [{"name": name, "unit": "", "values": [k + t for t in header["times"]]} for k, name in enumerate(names)]
        self.open([({**header, "series": series}, data)], "t=1")
        self.assertEqual(self.browser.evaluate("[...document.querySelectorAll('.plot .name')].map((e) => e.innerText)"),
                         names)
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('.plot .curve').length"), len(names))
        self.assert_quiet()

    def test_keys_are_listed(self):
        self.open([page_data.orbits()])
        self.browser.key("?", "?")
        self.assertTrue(self.browser.evaluate("document.querySelector('dialog').open"))

    def test_what_the_browser_lacks_is_said(self):
        self.open([page_data.orbits()], script="delete globalThis.DecompressionStream")
        self.assertIn("DecompressionStream", self.browser.evaluate("document.body.innerText"))
        self.open([page_data.orbits()], script="HTMLCanvasElement.prototype.getContext = () => null")
        self.assertIn("WebGL 2", self.browser.evaluate("document.body.innerText"))
        self.assertGreater(self.browser.evaluate("document.querySelectorAll('.plot').length"), 0)

    def test_broken_data_is_said(self):
        header, data = page_data.orbits()
        for broken in ({**header, "shown": 5}, {**header, "shown": 3}, {**header, "format": 2}):
            self.open([(broken, data)])
            self.assertIn("cannot be shown", self.browser.evaluate("document.body.innerText"))


# Only on a machine that does nothing else: `page_test.py --check-times`.
CHECK_TIMES = "--check-times" in sys.argv

if __name__ == "__main__":
    if CHECK_TIMES:
        sys.argv.remove("--check-times")
    if program() is None:
        print("skipped: no Chromium is installed, which this test needs", file=sys.stderr)
        sys.exit(77)
    unittest.main()
