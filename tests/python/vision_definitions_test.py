"""The numbers of ALVideoDevice are those of the C++ SDK, whose own are tested by their tables."""

import os
import re
import sys
import unittest

from support import ROOT

sys.path.insert(0, os.path.join(ROOT, "naoqi_api", "sdk", "python", "usarnaoqi_sdk", "offered"))
import vision_definitions  # noqa: E402
sys.path.pop(0)

HEADER = os.path.join(ROOT, "naoqi_api", "sdk", "cpp", "include", "alvision",
                      "alvisiondefinitions.h")


def constantsOfCpp():
    """{name: number}, also of names that are another's."""
    with open(HEADER, encoding="utf-8") as file:
        found = re.findall(r"^const (?:int|float) (k\w+) = ([\w.]+);", file.read(), re.M)
    numbers = {}
    for name, value in found:
        numbers[name] = numbers[value] if value in numbers else float(value.rstrip("f"))
    return numbers


class VisionDefinitions(unittest.TestCase):
    def testAreThoseOfTheHeader(self):
        own = {name: value for name, value in vars(vision_definitions).items()
               if name.startswith("k")}
        self.assertEqual(own, constantsOfCpp())
        self.assertGreater(len(own), 100)

    def testAreWholeNumbersButFieldsOfView(self):
        self.assertIsInstance(vision_definitions.k960p, int)
        self.assertIsInstance(vision_definitions.kApertureH_MT9M114, float)


if __name__ == "__main__":
    unittest.main()
