"""Python 2 programs, converted: what they print, where their modules come from, what stays."""

import os
import unittest

from python2_runner import Runner, needsTranslator


@needsTranslator
class Converted(Runner):
    def testOldWordsWork(self):
        self.assertEqual(self.run_(
            "import sys, Queue\n"
            "print 'one', `2`,\n"
            "print >>sys.stdout, u'drei'\n"
            "try:\n    raise ValueError, 'no'\n"
            "except ValueError, error:\n    print error\n"
            "print {1: 2}.has_key(1), map(str, xrange(2)), 0777, 7 <> 8\n"
            "print sorted([1, 3, 2], lambda a, b: cmp(b, a)), ord(b'a'[0])\n"),
            ["one 2 drei", "no", "True ['0', '1'] 511 True", "[3, 2, 1] 97"])

    def testWholeNumbersDivideDownwards(self):
        self.assertEqual(self.run_("a = 9\na /= 2\n"
                                   "print a, -7 / 2, 7 / 2.0, 640 / 3 * 3, 100 / 3 / 2 % 5, 1 // 2\n"
                                   "def half(x, y=7 / 2): return (x + y) / 2\n"
                                   "print half(4)\n"), ["4 -4 3.5 639 1 0", "3"])

    def testUnlessTheFutureIsAskedFor(self):
        self.assertEqual(self.run_("from __future__ import division, print_function\n"
                                   "print(1 / 2)\n"), ["0.5"])

    def testAnythingCompares(self):
        self.assertEqual(self.run_("print None < 3, [1] < 0.5, 'a' > 5, 2 <= (1,), 3 >= None\n"
                                   "print 1 < 2 < 3, [i for i in range(3) if i < 2]\n"
                                   "print sorted([2, None, 1], cmp)\n"),
                         ["True False True True True", "True [0, 1]", "[None, 1, 2]"])

    def testAGlobalMayBeDeclaredAfterItsUse(self):
        self.assertEqual(self.run_("FLAG = OTHER = 1\n"
                                   "def use():\n    if FLAG:\n        print FLAG\n"
                                   "    global FLAG, OTHER\n    FLAG = OTHER = 2\n"
                                   "def doc():\n    'text'\n    print OTHER\n    global OTHER\n"
                                   "    OTHER = 3\n"
                                   "use()\ndoc()\nprint FLAG, OTHER\n"), ["1", "2", "2 3"])

    def testTabsAreEightColumns(self):
        self.assertEqual(self.run_("if True:\n        a = 1\n\tb = 2\n\tprint a + b\n"), ["3"])

    def testUnlessThatMakesNoSense(self):
        self.assertEqual(self.run_("if True:\n\tfor i in range(2):\n        print i\n"), ["0", "1"])

    def testModulesAndFunctionsHaveTheirOldNames(self):
        os.mkdir(os.path.join(self.folder, "PIL"))
        self.write("PIL/__init__.py", "")
        self.write("PIL/Image.py", "class Image: tobytes = lambda self: b'pixels'\n"
                                   "def frombytes(mode, size, data): return Image()\n")
        self.assertEqual(self.run_("import Image\nfrom PIL import Image as new\n"
                                   "print Image.fromstring('RGB', (1, 2), '').tostring(), "
                                   "Image is new\n"), ["pixels True"])

    def testTheEncodingMayBeSet(self):
        self.assertEqual(self.run_("import sys\nreload(sys)\n"
                                   "sys.setdefaultencoding('utf-8')\nprint 'set'\n"), ["set"])

    def testTextsHaveBothMethods(self):
        self.assertEqual(self.run_(
            "name = 'Zo\\xc3\\xab'\n"
            "print 'caf'.decode('utf-8').upper(), u'ja'.encode('utf-8').decode('utf-8'),"
            " 'abc'.encode('hex'), '616263'.decode('hex').decode(), 'aGk='.decode('base64')\n"
            "data = {'a': [b'x'.decode('ascii')]}\nprint data['a'][0].decode().strip()\n"),
            ["CAF ja 616263 abc hi", "x"])

    def testModulesHaveWhatTheyLost(self):
        self.assertEqual(self.run_(
            "import string, sys, time\n"
            "print string.join(['a', 'b'], '-'), string.letters[:3], string.upper('x'),"
            " string.split('1 2'), string.atoi('7')\n"
            "print sys.maxint > 2 ** 30, time.clock() >= 0\n"),
            ["a-b abc X ['1', '2'] 7", "True True"])

    def testWhatIsAKeywordNowWasAName(self):
        self.assertEqual(self.run_("import qi\nprint qi.async(lambda: 5).value()\n"), ["5"])

    def testTheVersionIsTheOneThatWasAskedFor(self):
        self.assertEqual(self.run_("import sys\nif sys.version_info[0] > 2: raise Exception()\n"
                                   "print sys.version_info.major, sys.version_info < (3, 0)\n"),
                         ["2 True"])

    def testImportedModulesAreConvertedToo(self):
        self.write("helper.py", "print 'helper', 5 / 2\nNAME = __name__\n")
        self.assertEqual(self.run_("import helper\nprint helper.NAME, __name__\n"),
                         ["helper 2", "helper __main__"])

    def testWhatItImportsIsConvertedBeforeItRuns(self):
        self.write("helper.py", "import deeper\ntext = deeper.text\n")
        self.write("deeper.py", "print 'deeper'\ntext = `1`\n")
        self.write("broken.py", "this is no Python\n")
        self.assertEqual(self.run_(
            "import os\n"
            "copies = lambda: len(os.listdir(os.environ['USARNAOQI_PY2_FOLDER']))\n"
            "print copies()\n"
            "def later():\n    import helper\n    print helper.text\n"
            "later()\n"
            "print copies()\n"
            "try:\n    import broken\nexcept SyntaxError:\n    print 'broken'\n"),
            ["3", "deeper", "1", "3", "broken"])

    def testArgumentsFileAndExitCodeAreTheScriptsOwn(self):
        script = os.path.join(self.folder, "script.py")
        self.assertEqual(self.run_("import sys\nprint sys.argv, __file__\nsys.exit(4)\n", "a", "-b",
                                   code=4), ["%r %s" % ([script, "a", "-b"], script)])

    def testLinesKeepTheirNumbersAndTheSourceItsText(self):
        text = "# comment\n\"\"\"doc\"\"\"\nimport sys\n\nprint 1 / 0\n"
        self.run_(text, code=1)
        self.assertIn("line 5, in <module>", self.errors)
        with open(os.path.join(self.folder, "script.py"), encoding="utf-8") as file:
            self.assertEqual(file.read(), text)
        self.assertIn("converted by", self.errors)

    def testWhatIsNoPython2EitherIsTold(self):
        self.run_("print 'a'\ndef (:\n", code=2)
        self.assertIn("script.py:2: neither Python 3 nor Python 2", self.errors)


if __name__ == "__main__":
    unittest.main()
