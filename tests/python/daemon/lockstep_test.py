"""Programs in lockstep with their world: their time is its time, and every run is the same."""

import contextlib
import os
import re
import signal
import subprocess
import sys
import tempfile
import unittest

from programs import PATIENCE, PROGRAM, environment, needsDaemon

HERE = os.path.dirname(os.path.abspath(__file__))
CLOCK = os.path.join(HERE, "..", "..", "clock")
BUILT = os.path.join(os.path.dirname(os.path.abspath(PROGRAM)), "tests", "clock")
PYTHON = sys.executable

# The libraries of address and thread sanitizers want to be the first in a program, before ours.
needsPlainPrograms = unittest.skipIf(
    os.environ.get("USARNAOQI_SANITIZER", "") in ("address", "thread"),
    "programs with such a sanitizer can not be in lockstep")


def start(*words, options=()):
    return subprocess.Popen([PROGRAM, "run", *options, "--", *words], cwd=CLOCK,
                            env=environment(), text=True, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE)


def course(*words, options=()):
    """All that a run shows: what the program prints and how the world ends."""
    process = start(*words, options=options)
    try:
        out, err = process.communicate(timeout=PATIENCE)
    finally:
        process.kill()
    return process.returncode, out, err


def lolaCourse(program, *words):
    """The same of a LoLA program, SOCKET among its words its robot's; of the daemon's lines the
    last."""
    with tempfile.TemporaryDirectory() as folder:
        socket = os.path.join(folder, "robocup")
        words = [socket if word == "SOCKET" else word for word in words]
        code, out, err = course(program, *words, options=["--lola", socket])
    return code, out, re.search("ended at .*", err).group(0)


@contextlib.contextmanager
def busyLoops():
    """More than the machine can do at once."""
    hogs = [subprocess.Popen([PYTHON, "-c", "while True: pass"]) for _ in range(2)]
    try:
        yield
    finally:
        for hog in hogs:
            hog.kill()
            hog.wait()


@needsDaemon
class LockstepTest(unittest.TestCase):
    def expectSame(self, *words, options=()):
        first = course(*words, options=options)
        self.assertEqual(first[0], 0, first)
        self.assertRegex(first[2], "state [0-9a-f]{16}, run [0-9a-f]{16}, repeatable")
        with busyLoops():
            self.assertEqual(course(*words, options=options), first)
            self.assertEqual(course(*words, options=[*options, "--speed", "5"]), first)

    @needsPlainPrograms
    def testEveryFunctionThatWaitsTakesSimulatedTime(self):
        for probe in ["clocks", "sleeps", "descriptors", "locks", "futexes", "processes", "spins"]:
            with self.subTest(probe):
                code, out, err = course(os.path.join(BUILT, "clock_probe"), probe)
                self.assertEqual((code, out), (0, "1 probes, 0 failures\n"), err)

    @needsPlainPrograms
    def testTimeStandsUntilSomebodyWaitsHoweverManyClocksAreRead(self):
        looks = "import time\nfor _ in range(5000): time.monotonic()\n"
        now = "import time\nprint(time.monotonic())"
        at_once = course(PYTHON, "-c", now)[:2]
        self.assertEqual(at_once[0], 0)
        self.assertEqual(course(PYTHON, "-c", looks + now)[:2], at_once)
        later = "import time\ntime.sleep(0.01)\nbegun = time.monotonic()\n" + looks + (
            "print(time.monotonic() - begun > 0.03)")  # 4,000 of 10 us
        self.assertEqual(course(PYTHON, "-c", later)[:2], (0, "True\n"))

    def testAClientThatSleepsAndPollsIsTheSameEveryTime(self):
        self.expectSame(PYTHON, "sleeps_and_polls.py")

    def testAClientOfTwoThreadsIsTheSameEveryTime(self):
        self.expectSame(PYTHON, "two_threads.py")

    @needsPlainPrograms
    def testAClientInCppIsTheSameEveryTime(self):
        self.expectSame(os.path.join(BUILT, "clock_two_threads"))

    def testAClientThatLooksIsTheSameEveryTime(self):
        self.expectSame(PYTHON, "pictures.py", options=["--robot", "nao_h25_v50"])

    def testClocksGoOnWhileTheWorldIsSetBackOrPaused(self):
        code, out, err = course(PYTHON, "pauses.py")
        self.assertEqual(code, 0, err)
        self.assertEqual(out, "slept: 1.00 s here, 1.01 s there\n"
                              "set back: 2.00 s here, 1.01 s there\n"
                              "paused: 3.00 s here, 1.01 s there\n"
                              "stepped: 3.10 s here, 1.11 s there\n"
                              "resumed: 4.10 s here, 2.11 s there\n")

    def testAProgramOfSeveralProcessesIsTheSameEveryTime(self):
        self.expectSame("sh", "-c", "for i in 1 2 3; do sleep 0.$i & done; wait; date +%s.%N;"
                                    "x=$(sleep 1; date +%N); echo $x")

    def testALolaProgramDecidesWhereItsWorldEnds(self):
        sine = os.path.join(os.path.dirname(BUILT), "lola_sine")
        code, out, end = lolaCourse(sine, "SOCKET", "3")
        self.assertEqual((code, out), (0, "the head went 0.50 rad to the sides\n"))
        self.assertIn("ended at 3.012 s", end)  # a cycle when it came, and one an answer: 250
        with busyLoops():
            self.assertEqual(lolaCourse(sine, "SOCKET", "3"), (code, out, end))

    def testHowALolaProgramEndsDecidesNothing(self):
        ends = set()
        with busyLoops():
            for how, expected in [("exit", 0), ("late", 0), ("kill", 128 + 9)] * 3:
                code, _, end = lolaCourse(PYTHON, "lola_ends.py", "SOCKET", how)
                self.assertEqual(code, expected, end)
                ends.add(end)
        self.assertEqual(len(ends), 1, ends)
        self.assertIn("ended at 0.492 s", ends.pop())  # 40 answers

    def testTimeIsSimulatedWithoutLockstepToo(self):
        text = "import time; t = time.time(); time.sleep(20); print(time.time() - t)"
        code, out, err = course(PYTHON, "-c", text, options=["--no-lockstep", "--speed", "20"])
        self.assertEqual(code, 0, err)
        self.assertTrue(20 <= float(out) < 40, out)  # the wall has a part in it: at most 1 s

    def testTenMinutesPass(self):
        text = "import time; t = time.time(); time.sleep(600); print(time.time() - t)"
        self.assertEqual(course(PYTHON, "-c", text)[:2], (0, "600.0\n"))

    def testASpinIsReportedAndDoesNotHoldTheOthersUp(self):
        text = ("import threading, time\n"
                "done = []\n"
                "threading.Thread(target=lambda: (time.sleep(1), done.append(1))).start()\n"
                "import sys; sys.setswitchinterval(0.005)\n"
                "while not done: pass\n"
                "print('over')\n")
        code, out, err = course(PYTHON, "-c", text)
        self.assertEqual((code, out), (0, "over\n"), err)
        self.assertIn("computes, or spins, without looking at a clock", err)
        self.assertIn("not repeatable", err)

    def testAProgramThatBringsItsOwnLibraryIsRefusedLockstep(self):
        with tempfile.TemporaryDirectory() as folder:
            source = os.path.join(folder, "own.c")
            with open(source, "w", encoding="utf-8") as file:
                file.write("int main() { return 4; }\n")
            program = os.path.join(folder, "own")
            if subprocess.run(["cc", "-static", source, "-o", program], check=False,
                              capture_output=True).returncode != 0:
                self.skipTest("no static C library")
            code, _, err = course(program)
            self.assertEqual(code, 4)
            self.assertIn("is linked statically: it keeps its own time", err)

    def testAWorldThatIsKilledTakesItsProgramAlong(self):
        process = start(PYTHON, "-u", "-c",
                        "import os, time\nprint(os.getpid())\ntime.sleep(1e9)\n",
                        options=["--speed", "1"])
        program = int(process.stdout.readline())
        with open("/proc/%d/task/%d/children" % (process.pid, process.pid)) as file:
            children = [int(child) for child in file.read().split()]
        self.assertIn(program, children)
        children.remove(program)
        os.kill(children[0], signal.SIGKILL)
        _, err = process.communicate(timeout=PATIENCE)
        self.assertEqual(process.returncode, 1)
        self.assertIn("the world ended before the program did", err)
        self.assertFalse(os.path.exists("/proc/%d" % program))

    def testAKilledProcessOfAProgramIsNotWaitedFor(self):
        script = "python=$1; $python -c 'import os; os.kill(os.getpid(), 9)'; sleep 2; echo $?"
        code, out, err = course("sh", "-c", script, "sh", PYTHON)
        self.assertEqual((code, out), (0, "0\n"), err)
        self.assertTrue(re.search("ended at [23]", err), err)


if __name__ == "__main__":
    unittest.main()
