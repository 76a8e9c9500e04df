"""Every Python example, run as its reader would run it, on a robot whose time goes fast."""

import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from queue import Queue

from programs import EXAMPLES, PATIENCE, ROOT, daemon, enterDaemon, environment, needsDaemon, run
from usarnaoqi_sdk import Session

# Need more than a robot at an address: they have tests of their own.
EXCEPT = {"react_to_events.py", "lola_camera.py"}


@needsDaemon
class ExamplesTest(unittest.TestCase):
    def example(self, name, cwd=None):
        """What it prints, and the session of a witness to ask afterwards."""
        address = enterDaemon(self)
        printed = run([sys.executable, os.path.join(EXAMPLES, name)], cwd or EXAMPLES, address)
        session = Session(address)
        self.addCleanup(session.close)
        return printed, session

    def testEveryOneHasATest(self):
        with open(__file__, encoding="utf-8") as file:
            tested = re.findall(r'example\("(\w+\.py)"', file.read())
        there = {name for name in os.listdir(EXAMPLES) if name.endswith(".py")}
        self.assertEqual(there - EXCEPT, set(tested))

    def testSayHello(self):
        _, session = self.example("say_hello.py")
        spoken = session.service("ALMemory").getData("ALTextToSpeech/CurrentSentence")
        self.assertEqual(spoken, "")  # said to its end

    def testMoveHead(self):
        printed, _ = self.example("move_head.py")
        angles = [float(text) for text in re.findall(r"[-+][\d.]+", printed)]
        self.assertEqual(len(angles), 4)
        for angle in angles:  # back ahead; a servo's droop and an encoder's count beside it
            self.assertAlmostEqual(angle, 0.0, delta=0.03)

    def testWalk(self):
        printed, session = self.example("walk.py")
        self.assertIn("odometry: x", printed)
        x, y, _ = session.service("UsarSim").floorPose()
        # 30 cm ahead, as far as a walk without sight goes straight; sitting down moves it a little.
        self.assertLess(math.hypot(x - 0.3, y), 0.1, (x, y))

    def testGrabImage(self):
        with tempfile.TemporaryDirectory() as folder:
            self.example("grab_image.py", cwd=folder)
            with open(os.path.join(folder, "image.ppm"), "rb") as file:
                header, pixels = file.readline(), file.read()
        self.assertEqual(header, b"P6 640 480 255\n")
        self.assertEqual(len(pixels), 640 * 480 * 3)
        self.assertGreater(len(set(pixels)), 1)  # it sees something

    def testLolaCamera(self):
        with tempfile.TemporaryDirectory() as folder:
            field = os.path.join(ROOT, "worlds", "field_2020.yaml")
            lola = ["--lola", os.path.join(folder, "robocup"), "--world", field]
            with daemon(more_wires=["--lola-camera-port"], options=lola) as (_, camera):
                run([sys.executable, os.path.join(EXAMPLES, "lola_camera.py"), *camera.split(":")],
                    folder)
            with open(os.path.join(folder, "lola_camera.pgm"), "rb") as file:
                header, pixels = file.readline(), file.read()
        self.assertEqual(header, b"P5 640 480 255\n")
        self.assertEqual(len(pixels), 640 * 480)
        self.assertGreater(len(set(pixels)), 1)  # it sees something

    def testPlayMotion(self):
        printed, session = self.example("play_motion.py")
        self.assertEqual(printed, "plays for 6.0 s\n")
        _, _, height, roll, pitch, _ = session.service("UsarSim").torsoPose()
        self.assertGreater(height, 0.25)  # on its feet
        self.assertLess(math.hypot(roll, pitch), 0.3)

    def testQiSignals(self):
        printed, _ = self.example("qi_signals.py")
        self.assertEqual(printed.splitlines()[1], "the robot said: turning")
        self.assertAlmostEqual(float(printed.split()[2]), 0.5, delta=0.03)

    def testReactToEvents(self):
        # At full speed a touch is over before anybody is told.
        with daemon(speed="1") as address, Session(address) as session:
            process = subprocess.Popen(
                [sys.executable, os.path.join(EXAMPLES, "react_to_events.py")], text=True,
                env=environment(address), stdout=subprocess.PIPE)
            self.addCleanup(process.kill)
            self.assertEqual(process.stdout.readline(), "listening\n")
            touched, values = session.service("ALMemory").subscriber("FrontTactilTouched"), Queue()
            touched.signal.connect(values.put)
            for touch in range(1, 4):
                session.service("UsarSim").press("Head/Touch/Front", 0.2)
                self.assertEqual(process.stdout.readline(), "FrontTactilTouched: %d\n" % touch)
                # Once it is let go the next one is another touch.
                self.assertEqual([values.get(timeout=PATIENCE) for _ in range(2)], [1, 0])
            process.communicate(timeout=PATIENCE)
            self.assertEqual(process.returncode, 0)
            names = [info.name for info in session.services()]
            self.assertNotIn("counter", names)

    @unittest.skipUnless(shutil.which("perl"), "perl is not installed")
    def testMsgpackRpc(self):
        with daemon(more_wires=["--msgpack-port"]) as (_, address):
            printed = run(["perl", os.path.join(EXAMPLES, "msgpack_rpc.pl"), *address.split(":")],
                          EXAMPLES)
        angle, joints = re.findall(r"[\d.]+", printed)
        self.assertAlmostEqual(float(angle), 0.4, delta=0.03)  # a servo's droop
        self.assertEqual(joints, "22")


if __name__ == "__main__":
    unittest.main()
