"""The demo's own tools, and the timeline it plays."""

import os
import re
import struct
import sys
import unittest
import xml.etree.ElementTree as ElementTree
import zlib

from support import ROOT

sys.path.insert(0, os.path.join(ROOT, "scripts", "demo_tools"))

import page  # noqa: E402
import plot  # noqa: E402
import png  # noqa: E402
from client import Step  # noqa: E402
from recorder import Pose, Sample, inWorld  # noqa: E402

XAR = "{http://www.aldebaran-robotics.com/schema/choregraphe/project.xsd}"


class Png(unittest.TestCase):
    def testHoldsThePixels(self):
        pixels = bytes(range(2 * 3 * 3))
        chunks = dict(self.chunks(png.toPng(2, 3, pixels)))
        self.assertEqual(struct.unpack(">II", chunks[b"IHDR"][:8]), (2, 3))
        rows = zlib.decompress(chunks[b"IDAT"])
        self.assertEqual(b"".join(rows[i + 1:i + 7] for i in range(0, len(rows), 7)), pixels)
        self.assertEqual(set(rows[::7]), {0})  # no filter

    def chunks(self, data):
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        at = 8
        while at < len(data):
            (size,) = struct.unpack_from(">I", data, at)
            name, content = data[at + 4:at + 8], data[at + 8:at + 8 + size]
            (checksum,) = struct.unpack_from(">I", data, at + 8 + size)
            self.assertEqual(checksum, zlib.crc32(name + content))
            yield name, content
            at += 12 + size

    def testRefusesTooFewPixels(self):
        with self.assertRaises(ValueError):
            png.toPng(2, 2, bytes(11))


class Ticks(unittest.TestCase):
    def testAreRoundFewAndWithin(self):
        for low, high in ((0, 1), (-0.013, 0.021), (3.2, 26.7), (-100, 1e4), (0.4, 0.4001)):
            with self.subTest(low=low, high=high):
                ticks = plot.ticks(low, high)
                self.assertTrue(3 <= len(ticks) <= 9, ticks)
                self.assertEqual(len({text for _, text in ticks}), len(ticks))
                for value, text in ticks:
                    self.assertTrue(low - 1e-9 <= value <= high + 1e-9)
                    self.assertAlmostEqual(float(text), value)


class Page(unittest.TestCase):
    def html(self):
        samples = [Sample(0.05 * i, [0.1 * i], [0.1 * i], Pose(0.01 * i, 0, 0),
                          Pose(0.01 * i, 0, 0), (0, 0), (0, 0)) for i in range(40)]
        return page.toHtml(["LKneePitch"], samples, [Step("a <step>", 0, 2)], [("f", "1 m")],
                           [("top", png.toPng(1, 1, b"abc"))])

    def testAsksForNothingFromElsewhere(self):
        for source in re.findall(r'(?:src|href|url)\s*[=(]\s*"?([^")>]*)', self.html()):
            self.assertTrue(source.startswith("data:"), source)
        self.assertNotIn("<script", self.html())

    def testIsWellFormed(self):
        body = re.search("<body>.*</body>", self.html(), re.DOTALL).group(0)
        root = ElementTree.fromstring(body)
        # Two curves each: the tracks, one joint, roll and pitch.
        self.assertEqual(len(list(root.iter("polyline"))), 8)
        self.assertIn("a <step>", [cell.text for cell in root.iter("td")])


class Odometry(unittest.TestCase):
    def testIsLaidOverTheTruthWhereBothAreKnown(self):
        # A quarter turn lies between the frames: ahead by odometry is to the left in the world.
        known, known_in_world = Pose(5, 5, 0), Pose(1, 2, 1.5707963267948966)
        placed = inWorld(Pose(5.5, 5, 0.25), known, known_in_world)
        for value, expected in zip(placed, (1, 2.5, 1.8207963267948966)):
            self.assertAlmostEqual(value, expected)


class HelloTimeline(unittest.TestCase):
    LIMITS = {  # deg, of the V3.3 body; from body.yaml's source
        "HeadYaw": (-119.5, 119.5), "HeadPitch": (-38.5, 29.5), "RShoulderPitch": (-119.5, 119.5),
        "RShoulderRoll": (-76, 18), "RElbowYaw": (-119.5, 119.5), "RElbowRoll": (2, 88.5),
        "HipPitch": (-88, 27.73), "KneePitch": (-5.29, 121.04), "AnklePitch": (-67.97, 52.86)}

    def setUp(self):
        path = os.path.join(ROOT, "examples", "motions", "hello.xar")
        self.project = ElementTree.parse(path).getroot()
        (self.timeline,) = [timeline for timeline in self.project.iter(XAR + "Timeline")
                            if timeline.get("enable") == "1"]
        self.curves = {curve.get("actuator"): [(int(key.get("frame")), float(key.get("value")))
                                               for key in curve.iter(XAR + "Key")]
                       for curve in self.timeline.iter(XAR + "ActuatorCurve")}

    def testLastsSixSeconds(self):
        last = max(frame for keys in self.curves.values() for frame, _ in keys)
        start, fps = int(self.timeline.get("start_frame")), float(self.timeline.get("fps"))
        self.assertEqual((last - start) / fps, 6)

    def testStaysWithinTheLimits(self):
        for name, keys in self.curves.items():
            low, high = self.LIMITS.get(name) or self.LIMITS[name[1:]]
            for frame, value in keys:
                self.assertTrue(low < value < high, (name, frame, value))

    def testStaysBelowTwoThirdsOfAKneesTopSpeed(self):
        for name, keys in self.curves.items():
            for (frame, value), (next_frame, next_value) in zip(keys, keys[1:]):
                speed = abs(next_value - value) * 25 / (next_frame - frame)  # deg/s, on average
                self.assertLess(speed * 1.5, 240, name)  # a smooth curve peaks at 1.5 times that

    def testTheLegsMoveAlikeWithTheTorsoUpright(self):
        for name in ("HipPitch", "KneePitch", "AnklePitch"):
            self.assertEqual(self.curves["L" + name], self.curves["R" + name])
        pitches = [sum(values) for values in zip(*(
            [value for _, value in self.curves["L" + name]]
            for name in ("HipPitch", "KneePitch", "AnklePitch")))]
        self.assertEqual(len(pitches), 3)
        for pitch in pitches:
            self.assertAlmostEqual(pitch, pitches[0])


if __name__ == "__main__":
    unittest.main()
