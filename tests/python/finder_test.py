"""Who provides naoqi, qi and the others: this package, unless somebody else does."""

import os
import subprocess
import sys
import tempfile
import unittest
import zipfile

from support import ROOT

SDK = os.path.join(ROOT, "naoqi_api", "sdk", "python")


class Offered(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    def run_(self, code, path=SDK, options=()):
        environment = dict(os.environ, PYTHONPATH=path, PYTHONDONTWRITEBYTECODE="1")
        done = subprocess.run([sys.executable, *options, "-c", code], env=environment, text=True,
                              cwd=self.folder, capture_output=True, timeout=60, check=False)
        self.assertEqual(done.stderr, "")
        return done.stdout.strip()

    def testAPathIsEnough(self):
        code = ("import naoqi, qi, qi.logging, almath, motion, vision_definitions as v\n"
                "print(naoqi.ALProxy.__name__, getattr(qi, 'async').__name__, motion.FRAME_ROBOT, "
                "v.kVGA, almath.PI > 3, qi.logging.Logger('x').category)")
        self.assertEqual(self.run_(code), "ALProxy async_ 2 2 True x")

    def testNaoqiHasTheModulesBesideIt(self):
        code = ("from naoqi import *\nfrom naoqi import motion, almath\nimport naoqi\n"
                "print(ALProxy.__name__, motion.FRAME_TORSO, almath.PI > 3, hasattr(naoqi, 'other'))")
        self.assertEqual(self.run_(code), "ALProxy 0 True False")

    def testAProgramsOwnModulesComeFirst(self):
        self.write("motion.py", "FRAME_ROBOT = 'mine'")
        self.write("qi.py", "Session = 'real'")
        self.assertEqual(self.run_("import motion, qi; print(motion.FRAME_ROBOT, qi.Session)"),
                         "mine real")

    def testAFolderOfTheNameIsNoModuleUnlessItIsAPackage(self):
        os.mkdir(os.path.join(self.folder, "motion"))
        os.mkdir(os.path.join(self.folder, "qi"))
        self.write("qi/__init__.py", "Session = 'package'")
        self.assertEqual(self.run_("import motion, qi; print(motion.FRAME_ROBOT, qi.Session)"),
                         "2 package")

    def testSoDoThoseOfAFinderThatIsAddedLater(self):
        self.write("late.py", """
import sys
from importlib.machinery import PathFinder
class Late:
    def find_spec(self, name, path=None, target=None):
        return PathFinder.find_spec(name, ["elsewhere"])
sys.meta_path.append(Late())
""")
        os.mkdir(os.path.join(self.folder, "elsewhere"))
        self.write("elsewhere/qi.py", "Session = 'editable'")
        self.assertEqual(self.run_("import late, qi; print(qi.Session)"), "editable")

    def testTheUsersSitecustomizeRunsToo(self):
        self.write("sitecustomize.py", "import builtins; builtins.greeting = 'hello'")
        self.assertEqual(self.run_("import qi; print(greeting)", SDK + os.pathsep + self.folder),
                         "hello")

    def testAStartOfPythonLoadsTheFinderAlone(self):
        code = "import sys; print(sorted(m for m in sys.modules if 'usarnaoqi' in m))"
        self.assertEqual(self.run_(code), "['usarnaoqi_sdk', 'usarnaoqi_sdk.finder']")

    def testTheWheelHasEverythingAndStartsTheFinder(self):
        code = ("import os, sys; os.chdir(%r); sys.path.insert(0, '.'); import wheel_builder; "
                "print(wheel_builder.build_wheel(%r))" % (SDK, self.folder))
        wheel = os.path.join(self.folder, self.run_(code, ""))
        with zipfile.ZipFile(wheel) as content:
            names = set(content.namelist())
            content.extractall(os.path.join(self.folder, "site"))
        self.assertIn("usarnaoqi_sdk/offered/qi/__init__.py", names)
        site = os.path.join(self.folder, "site")
        code = "import site; site.addsitedir(%r); import qi; print(qi.__file__)" % site
        self.assertEqual(self.run_(code, ""),
                         os.path.join(site, "usarnaoqi_sdk", "offered", "qi", "__init__.py"))


if __name__ == "__main__":
    unittest.main()
