"""usarnaoqi ci: scenarios with clients in processes of their own, verdicts, files."""

import json
import os
import re
import unittest
import xml.etree.ElementTree

from programs import FolderTest, needsDaemon

CLIENT = """
import sys, time
from naoqi import ALProxy
memory = ALProxy("ALMemory")
for number in range(1, 4):
    time.sleep(0.5)
    memory.raiseEvent("Test/Number", number)
ALProxy("ALTextToSpeech").say("done " + sys.argv[1])
sys.exit(int(sys.argv[1]))
"""

SCENARIO = """
about: A program counts.
duration: 4
seeds: [1, 2]
spread: {push: [2, 4]}
clients: [{name: counts, run: python3 client.py %(code)d}]
events: [{at: 1, push: {force: [$push, 0, 0], for: 0.1}}]
expect:
  - {event: {key: Test/Number, equals: 3}, by: 3}
  - {said: {text: done}, by: 3}
  - {upright: {}}
"""


def withoutTimes(xml_text):
    return re.sub(r'time="[0-9.]*"', "", xml_text)


@needsDaemon
class ScenarioTest(FolderTest):
    def setUp(self):
        super().setUp()
        self.write("client.py", CLIENT)

    def testWhatPassesIsTheSameEveryTime(self):
        self.write("counts.yaml", SCENARIO % {"code": 0})
        for name in ("one", "two"):
            done = self.usarnaoqi("ci", ".", "--jobs", "2", "--junit", name + ".xml", "--json")
            figures = json.loads(done.stdout)["figures"]
            self.assertEqual([figures[key] for key in ("scenarios", "passed", "failed")],
                             [2, 2, 0])
            self.usarnaoqi("run", "--scenario", "counts.yaml", "--seed", "2", "--result",
                           name + ".json")
        self.assertEqual(withoutTimes(self.read("one.xml")), withoutTimes(self.read("two.xml")))
        one, two = (json.loads(self.read(name + ".json")) for name in ("one", "two"))
        self.assertEqual(one["hash"], two["hash"])
        self.assertEqual(one["drawn"], two["drawn"])

    def testWhatFailsIsToldAndKept(self):
        self.write("counts.yaml", SCENARIO % {"code": 5})
        done = self.usarnaoqi("ci", "counts.yaml", "--seeds", "1", "--junit", "out.xml",
                              "--record", "failed", code=1)
        told = "expected counts ends with exit code 0 by 4 s; closest: ended with exit code 5"
        self.assertIn(told, done.stderr)
        self.assertIn("again: usarnaoqi run --scenario counts.yaml --seed 1", done.stderr)
        suite = xml.etree.ElementTree.parse(os.path.join(self.folder, "out.xml")).getroot()
        (failure,) = suite.iter("failure")
        self.assertIn(told, failure.text)
        self.usarnaoqi("replay", "counts-1.run")

    def testABrokenScenarioIsRefusedBeforeAnythingRuns(self):
        self.write("counts.yaml", SCENARIO % {"code": 0} + "  - {uprigth: {}}\n")
        done = self.usarnaoqi("ci", ".", code=2)
        self.assertIn("counts.yaml:12: `uprigth`: unknown, expected one of", done.stderr)


if __name__ == "__main__":
    unittest.main()
