"""serve and run --record, replay: what was recorded is done again to the last bit."""

import os
import re
import subprocess
import unittest

from programs import FolderTest, PATIENCE, PROGRAM, environment, needsDaemon

WALK = """
from naoqi import ALProxy
motion = ALProxy("ALMotion")
motion.wakeUp()
ALProxy("ALLeds").fadeRGB("FaceLeds", 0x00ff00, 0.2)
motion.moveTo(0.1, 0, 0)
"""

# Walks on and on, and says each second how far it is.
WALK_ON = """
import time
from naoqi import ALProxy
motion = ALProxy("ALMotion")
motion.wakeUp()
motion.moveToward(0.5, 0, 0.2)
world = ALProxy("UsarSim")
world.pause()
while True:
    world.step(500)
    print(world.time(), flush=True)
"""


@needsDaemon
class RecordingTest(FolderTest):
    def replay(self, *words, code=0):
        return self.usarnaoqi("replay", *words, code=code).stdout

    def record(self, name, program=WALK, *options):
        script = self.write("program.py", program)
        self.usarnaoqi("run", "--speed", "max", *options, "--record", name, "--", "python3", script)

    def testARunIsDoneAgainToTheLastBit(self):
        self.record("run.rec")
        text = self.replay("run.rec", "--inputs")
        self.assertRegex(text, r"nao  WakeUp\n")
        self.assertRegex(text, r"nao  MoveTo\n")
        self.assertRegex(text, r"all \d+ recorded states are the same to the last bit")
        self.assertEqual(sorted(os.listdir(self.folder)), ["program.py", "run.rec"])
        self.assertRegex(self.replay("run.rec", "--from", "1", "--to", "2"),
                         r"from 1.000 to 2.000 s all 11 recorded states are the same")
        self.replay("run.rec", "--from", "99", code=2)  # where there is nothing to be the same
        self.replay("run.rec", "--from", "2", "--to", "1", code=2)

    def testTwoRunsAreCompared(self):
        self.record("one.rec")
        self.record("other.rec", WALK.replace("0.1, 0, 0", "0.1, 0.05, 0"))
        self.assertIn("same states to the last bit", self.replay("one.rec", "--diff", "one.rec"))
        text = self.replay("one.rec", "--diff", "other.rec", code=20)
        self.assertRegex(text, r"MoveTo of nao at [\d.]+ s has other values there")
        self.assertRegex(text, r"their states part at [\d.]+ s")

    def testOnAnotherRobotItPartsAtOnce(self):
        self.record("run.rec")
        text = self.replay("run.rec", "--set", "robot.effects.backlash=0")
        self.assertIn("their states part at 0.002 s", text)
        self.replay("run.rec", "--set", "robot.effects.magic=0", code=2)

    def testItsSignalsAreASetLikeAMeasuredOne(self):
        self.record("run.rec")
        self.replay("run.rec", "--from", "1", "--csv", "run.csv", "--set-out", "set")
        rows = self.read("run.csv").splitlines()
        self.assertEqual(float(rows[1].split(",")[0]), 1)
        self.assertIn("q.LKneePitch", rows[0].split(","))
        self.assertRegex(self.read("set/run.csv").splitlines()[1], r"^0(\.0*)?,")
        self.assertIn("No fault was found", self.usarnaoqi("check-data", "set").stdout)

    def testWhatIsNoRecordingIsToldInOneSentence(self):
        self.write("text", "no recording\n")
        done = self.usarnaoqi("replay", "text", code=2)
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn("text: file is not a database", done.stderr)

    def testAfterAKillItIsThereUpToTheLastSecond(self):
        record = os.path.join(self.folder, "run.rec")
        daemon = subprocess.Popen([PROGRAM, "serve", "--port", "0", "--speed", "max",
                                   "--record", record], stdout=subprocess.PIPE, text=True)
        self.addCleanup(daemon.stdout.close)
        address = daemon.stdout.readline().partition("://")[2].strip()
        client = subprocess.Popen(["python3", "-u", self.write("program.py", WALK_ON)],
                                  cwd=self.folder, env=environment(address),
                                  stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.addCleanup(client.stdout.close)
        seen = [float(client.stdout.readline()) for _ in range(5)]
        daemon.kill()
        daemon.wait(PATIENCE)
        client.kill()
        client.wait(PATIENCE)
        text = self.replay("run.rec")
        self.assertIn("it was cut short", text)
        end = float(re.search(r"from 0.000 to ([\d.]+) s all", text).group(1))
        self.assertGreaterEqual(end, seen[-1] - 1)


if __name__ == "__main__":
    unittest.main()
