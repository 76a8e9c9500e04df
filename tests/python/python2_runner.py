"""Runs texts of Python 2 as `usarnaoqi run --py2` does."""

import os
import subprocess
import sys
import tempfile
import unittest

from support import ROOT

SDK = os.path.join(ROOT, "naoqi_api", "sdk", "python")


def hasTranslator():
    found = subprocess.run([sys.executable, "-W", "ignore", "-c",
                            "from usarnaoqi_sdk.python2.translate import Translator; Translator()"],
                           env=dict(os.environ, PYTHONPATH=SDK), capture_output=True, check=False)
    return found.returncode == 0


needsTranslator = unittest.skipUnless(hasTranslator(),
                                      "this Python has neither lib2to3 nor fissix")


class Runner(unittest.TestCase):
    """The base of tests of converted programs."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def run_(self, text, *arguments, code=0):
        script = self.write("script.py", text)
        copies = tempfile.TemporaryDirectory()
        self.addCleanup(copies.cleanup)
        environment = dict(os.environ, PYTHONPATH=SDK, USARNAOQI_PY2_FOLDER=copies.name,
                           PYTHONDONTWRITEBYTECODE="1", PYTHONIOENCODING="utf-8")
        done = subprocess.run([sys.executable, "-m", "usarnaoqi_sdk.python2", script, *arguments],
                              env=environment, text=True, cwd=self.folder, capture_output=True,
                              timeout=60, encoding="utf-8", check=False)
        self.assertEqual(done.returncode, code, done.stderr)
        self.errors = done.stderr
        return done.stdout.splitlines()
