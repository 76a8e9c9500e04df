"""Shared by the tests that need a daemon: one on a free port, and programs run against it."""

import contextlib
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(HERE)))
SDK = os.path.join(ROOT, "naoqi_api", "sdk", "python")
EXAMPLES = os.path.join(ROOT, "examples")
PROGRAM = os.environ.get("USARNAOQI", os.path.join(ROOT, "build", "usarnaoqi"))
PATIENCE = 120  # s of the wall; far more than any of it takes, and reached only by a failing test

sys.path.insert(0, SDK)

needsDaemon = unittest.skipUnless(os.path.exists(PROGRAM), "%s is not built" % PROGRAM)


@contextlib.contextmanager
def daemon(speed="max", more_wires=(), options=()):
    """Yields host:port of a daemon of its own, whose time goes as fast as the machine allows. With
    options of other wires, such as --msgpack-port, a list: qi's address, then theirs."""
    command = [PROGRAM, "serve", "--port", "0", "--speed", speed, *options]
    for wire in more_wires:
        command += [wire, "0"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    try:
        lines = [process.stdout.readline() for _ in range(1 + len(more_wires))]
        addresses = [line.partition("://")[2].strip() for line in lines]
        if not all(addresses):
            raise AssertionError("the daemon did not start: %s" % " ".join(command))
        yield addresses if more_wires else addresses[0]
    finally:
        process.terminate()
        process.communicate()


def environment(address=None, **more):
    """For a program that finds the client, and the robot at `address`."""
    ours = dict(os.environ, PYTHONPATH=SDK, PYTHONDONTWRITEBYTECODE="1", **more)
    for name in ("NAO_IP", "NAOQI_ADDRESS"):
        ours.pop(name, None)
    if address:
        ours["NAOQI_ADDRESS"] = address
    return ours


def enterDaemon(test, **options):
    """The address of a daemon that lives as long as the test."""
    context = daemon(**options)
    address = context.__enter__()
    test.addCleanup(context.__exit__, None, None, None)
    return address


def run(command, cwd, address=None, code=0):
    """What the program prints; checks its exit code."""
    done = subprocess.run(command, cwd=cwd, env=environment(address), text=True,
                          capture_output=True, timeout=PATIENCE, check=False)
    if done.returncode != code:
        raise AssertionError("%s: exit code %d\n%s%s" % (command, done.returncode, done.stdout,
                                                         done.stderr))
    return done.stdout


class FolderTest(unittest.TestCase):
    """Tests that write and start programs in a folder of their own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)
        return name

    def read(self, name):
        with open(os.path.join(self.folder, name), encoding="utf-8") as file:
            return file.read()

    def usarnaoqi(self, *words, code=0, **more):
        """Runs our program; what it printed. Checks its exit code, unless that is None."""
        done = subprocess.run([PROGRAM, *words], cwd=self.folder, env=environment(**more),
                              text=True, capture_output=True, timeout=PATIENCE, check=False)
        if code is not None:
            self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done
