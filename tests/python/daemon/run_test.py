"""usarnaoqi run: the program's robot, its exit code, its end and ours."""

import os
import signal
import subprocess
import unittest

from programs import FolderTest, PATIENCE, PROGRAM, environment, needsDaemon

HARD_CODED = """
from naoqi import ALProxy
print(len(ALProxy("ALMotion", "192.168.1.77", 9559).getBodyNames("Body")))
"""


# A signal that comes just before signal.pause() does not end it: a pipe keeps what came.
AWAIT = ("import os, signal\ncame, comes = os.pipe()\nos.set_blocking(comes, False)\n"
         "signal.set_wakeup_fd(comes)\n")


@needsDaemon
class RunTest(FolderTest):
    def run_(self, *words, code=0):
        return self.usarnaoqi("run", *words, code=code).stdout

    def start(self, text, *options):
        """A program under way, once it has printed a line."""
        script = self.write("waits.py", text)
        ours = environment(TMPDIR=self.folder)
        process = subprocess.Popen([PROGRAM, "run", *options, "--", "python3", "-u", script],
                                   cwd=self.folder, env=ours, stdout=subprocess.PIPE,
                                   stderr=subprocess.DEVNULL, text=True)
        self.addCleanup(process.stdout.close)
        return process, process.stdout.readline().strip()

    def testAProgramFindsTheRobotWhateverItsAddress(self):
        script = self.write("script.py", HARD_CODED)
        self.assertEqual(self.run_("--", "python3", script), "22\n")
        self.assertEqual(self.run_("--robot", "nao_h25_v50", script), "26\n")

    def testOneOfSeveralRobotsIsMeantByItsPortOrItsHost(self):
        script = self.write("script.py", (
            "from naoqi import ALProxy\n"
            "for host, port in (('127.0.0.1', 9559), ('localhost', 9559), ('127.0.0.1', 9560),\n"
            "                   ('10.0.0.2', 9559)):\n"
            "    print(len(ALProxy('ALMotion', host, port).getBodyNames('Body')))\n"))
        self.assertEqual(self.run_("--robot", "nao_h21_v33", "--robot", "nao_h25_v50", script),
                         "22\n22\n26\n26\n")

    def testArgumentsAndExitCodeAreTheProgramsOwn(self):
        script = self.write("script.py", "import sys; print(sys.argv[1:]); sys.exit(7)")
        self.assertEqual(self.run_("--", "python3", script, "--robot", "x", code=7),
                         "['--robot', 'x']\n")

    def testASignalThatEndsTheProgramIsTold(self):
        script = self.write("script.py", "import os; os.kill(os.getpid(), 9)")
        self.run_("--", "python3", script, code=128 + 9)

    def testWhatIsNoProgramIsTold(self):
        self.run_("--", "./no-such-program", code=127)
        self.run_(code=2)
        self.run_("--result", "r.json", "--", "true", code=2)  # of a scenario alone
        self.run_("--scenario", "s.yaml", "--", "true", code=2)

    def testPython2IsConvertedAndNothingStays(self):
        self.write("old.py", "import sys\nfrom naoqi import ALProxy\n"
                             "print 'halves', 7 / 2, sys.argv[1]\n")
        done = self.usarnaoqi("run", "--py2", "--", "python2.7", "old.py", "word", code=None,
                              TMPDIR=self.folder)
        if "neither lib2to3" in done.stderr or "no lib2to3" in done.stderr:
            self.skipTest("python3 has no lib2to3")
        self.assertEqual((done.returncode, done.stdout), (0, "halves 3 word\n"), done.stderr)
        self.assertIn("old.py: Python 2, converted by", done.stderr)
        self.assertEqual(os.listdir(self.folder), ["old.py"])

    def testASignalToUsIsHandedOnAndTheRobotStaysMeanwhile(self):
        process, _ = self.start(AWAIT + "import sys\nfrom naoqi import ALProxy\n"
                                "def end(*_):\n"
                                "    print(ALProxy('ALMotion').ping())\n"
                                "    sys.exit(5)\n"
                                "signal.signal(signal.SIGTERM, end)\n"
                                "print('ready')\nos.read(came, 1)\n")
        process.terminate()
        self.assertEqual(process.communicate(timeout=PATIENCE)[0], "True\n")
        self.assertEqual(process.returncode, 5)

    def testCtrlCIsTheProgramsAffair(self):
        process, _ = self.start(AWAIT + "from naoqi import ALProxy\n"
                                "try:\n    print('ready')\n    os.read(came, 1)\n"
                                "except KeyboardInterrupt:\n"
                                "    ALProxy('ALMotion').rest()\n"
                                "    print('rests')\n")
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.communicate(timeout=PATIENCE)[0], "rests\n")
        self.assertEqual(process.returncode, 0)

    def testAKilledRunTakesItsProgramAlong(self):
        process, pid = self.start("import os, signal\nprint(os.getpid())\nsignal.pause()\n")
        handle = os.pidfd_open(int(pid))
        self.addCleanup(os.close, handle)
        process.send_signal(signal.SIGKILL)
        process.wait(PATIENCE)
        import select
        self.assertEqual(select.select([handle], [], [], PATIENCE)[0], [handle])


if __name__ == "__main__":
    unittest.main()
