"""What programs of Python 2's days do, converted. The answers are those of Python 2.7.18."""

import unittest

from python2_runner import Runner, needsTranslator


@needsTranslator
class Idioms(Runner):
    def prints(self, text, *lines):
        self.assertEqual(self.run_(text), list(lines))

    def testMapFilterAndZipMakeLists(self):
        self.prints("m = map(lambda x: x * 2, [1, 2])\n"
                    "print m, m[0], len(filter(None, [0, 1])), zip([1], [2])[0]\n"
                    "print map(None, [1, 2], [3]), map(lambda a, b: (a, b), [1, 2], [3])\n"
                    "print filter(lambda c: c != 'a', 'abc'), filter(None, (1, 0))\n"
                    "f = map\nprint f(str, [1])[0], dict(map(None, ['a'], [1]))\n",
                    "[2, 4] 2 1 (1, 2)", "[(1, 3), (2, None)] [(1, 3), (2, None)]", "bc (1,)",
                    "1 {'a': 1}")

    def testItertoolsAreLazy(self):
        self.prints("import itertools\nfrom itertools import imap, izip, count\n"
                    "print imap(str, count(3)).next(), izip('ab', count()).next()\n"
                    "print list(itertools.izip_longest([1], [])), "
                    "list(itertools.ifilter(None, [0, 1]))\n",
                    "3 ('a', 0)", "[(1, None)] [1]")

    def testSortsByComparisonAndWhatDoesNotCompare(self):
        self.prints("l = [3, 1, 2]\nl.sort(lambda a, b: cmp(b, a))\nprint l\n"
                    "l.sort(cmp=lambda a, b: cmp(a, b), reverse=True)\nprint l\n"
                    "mixed = ['a', 1, None]\nmixed.sort()\nprint mixed\n"
                    "print sorted([-3, 1], key=abs), sorted([1, 2], lambda a, b: b - a)\n",
                    "[3, 2, 1]", "[3, 2, 1]", "[None, 1, 'a']", "[1, -3] [2, 1]")

    def testChainsOfComparisons(self):
        self.prints("x = None\nprint 0 <= x < 5, -1 < 0 <= 3 < 4, x < 1 < 2, 1 == 1 < 'a' != 3\n"
                    "print 1 < 0 < missing, [i for i in range(5) if 1 < i <= 3]\n"
                    "n = 0\nwhile -1 < n < 2: n += 1\nprint n\n",
                    "False True True True", "False [2, 3]", "2")

    def testErrorsAreTextsAndLists(self):
        self.prints("try:\n    raise ValueError('no', 2)\n"
                    "except ValueError, e:\n    print e[0], e[1], repr(e.message)\n"
                    "try:\n    raise IOError('gone')\nexcept IOError as e:\n    print e.message\n"
                    "class Own(Exception):\n    def __init__(self): self.message = 'own'\n"
                    "try:\n    raise Own\nexcept Own, e:\n    e.message += '!'\n"
                    "    print e.message\n"
                    "e = [[7, 8]]\nprint e[0][1]\n",
                    "no 2 ''", "gone", "own!", "8")

    def testClassesMayHaveTheirOldMethods(self):
        self.prints("class A:\n"
                    "    def __init__(self, x): self.x = x\n"
                    "    def __cmp__(self, other): return cmp(self.x, other.x)\n"
                    "    def __div__(self, other): return 'divided'\n"
                    "    def __nonzero__(self): return False\n"
                    "    def __unicode__(self): return u'uni'\n"
                    "class B(object):\n    def __eq__(self, other): return True\n"
                    "print A(1) < A(2), A(1) == A(1), sorted([A(2), A(1)])[0].x, A(1) != A(2)\n"
                    "print A(1) / 2, bool(A(1)), unicode(A(1)), len(set([B()]))\n",
                    "True True 1 True", "divided False uni 1")

    def testEncodedTextIsTextWhereItMeetsText(self):
        self.prints("name = u'Zo\\xeb'.encode('utf-8')\n"
                    "print 'I am %s' % name, 'and ' + name, name + '!'\n"
                    "print ' '.join(['a', u'b'.encode('ascii')]), {'k': 1}[u'k'.encode('utf-8')]\n"
                    "print u'a,b'.encode('utf-8').split(','), 'x' in u'xy'.encode('utf-8')\n"
                    "print 'Zo\\xc3\\xab'.decode('utf-8') == u'Zo\\xeb', 'ab'.encode('utf-8')\n"
                    "import sys\nsys.stdout.write(u'out\\n'.encode('utf-8'))\n",
                    "I am Zoë and Zoë Zoë!", "a b 1", "['a', 'b'] True", "True ab", "out")

    def testEncodedTextIsAString(self):
        self.prints("import json, re\nname = u'ab'.encode('utf-8')\n"
                    "print isinstance(name, str), re.sub('a', 'b', name), json.dumps([name])\n"
                    "print 'abc'.replace(name, 'x'), sorted([name, 'aa']), name < 'b'\n"
                    "print u'a\\xeb'.encode('ascii', 'ignore'), len(u'\\xeb'.encode('latin-1'))\n"
                    "print chr(200).encode('hex'), 'c8'.decode('hex') == chr(200), b'a' == 'a'\n",
                    "True bb [\"ab\"]", "xc ['aa', 'ab'] True", "a 1", "c8 True True")

    def testOtherProgramsAreTalkedToInText(self):
        self.prints("import subprocess\n"
                    "cat = subprocess.Popen(['cat'], stdin=subprocess.PIPE, "
                    "stdout=subprocess.PIPE)\nprint cat.communicate('hi')[0]\n"
                    "echo = subprocess.Popen('echo a; echo b', shell=True, "
                    "stdout=subprocess.PIPE)\n"
                    "print [line.strip() for line in echo.stdout], echo.wait()\n"
                    "print subprocess.check_output(['echo', 'a']).strip() == 'a'\n",
                    "hi", "['a', 'b'] 0", "True")

    def testAnArrayOfBytesIsMadeOfText(self):
        self.prints("import array\na = bytearray('ab\\xff')\nprint a[0], len(a), isinstance(a, "
                    "bytearray)\nprint str(bytearray('ab')), array.array('B', 'ab')[1]\n",
                    "97 3 True", "ab 98")

    def testWhatIsPrintedMayGoElsewhere(self):
        self.prints("import sys\nclass Tee:\n"
                    "    def write(self, text): sys.__stdout__.write(text.upper())\n"
                    "sys.stdout = Tee()\nprint 'a'\n", "A")
        self.assertNotIn("flush", self.errors)

    def testFilesTakeTextAndBytes(self):
        self.prints("f = open('f', 'wb')\nf.write('abc\\xff\\x00')\nf.close()\n"
                    "data = open('f', 'rb').read()\nprint len(data), data[0], ord(data[3])\n"
                    "f = file('t', 'w')\nf.write(u'\\xe9\\n'.encode('utf-8'))\nf.close()\n"
                    "print open('t', 'rU').readline().strip()\n"
                    "import csv, pickle\n"
                    "f = open('a.csv', 'wb')\ncsv.writer(f).writerow([1, 'b'])\nf.close()\n"
                    "print list(csv.reader(open('a.csv', 'rb')))\n"
                    "f = open('p', 'w')\npickle.dump([1], f)\nf.close()\n"
                    "print pickle.load(open('p'))\n",
                    "5 a 255", "é", "[['1', 'b']]", "[1]")

    def testSocketsTakeTextAndGiveWhatIsText(self):
        self.prints("import socket, struct\na, b = socket.socketpair()\n"
                    "a.send('hello %d\\n' % 1)\nd = b.recv(100)\n"
                    "print d.strip(), d.split(), d == 'hello 1\\n', 'hello' in d, d[0]\n"
                    "a.sendall(struct.pack('<Hb', 258, -1) + 'end')\nd = b.recv(100)\n"
                    "print struct.unpack('<Hb', d[:3]), [ord(c) for c in d[:3]], d[3:]\n"
                    "a.send(''.join([chr(c) for c in (1, 200)]) + 'x' + chr(233))\n"
                    "print [ord(c) for c in b.recv(9)]\n",
                    "hello 1 ['hello', '1'] True True h", "(258, -1) [2, 1, 255] end",
                    "[1, 200, 120, 233]")

    def testLibrariesTakeTextForBytes(self):
        self.prints("import base64, binascii, hashlib, md5\n"
                    "h = hashlib.md5('a')\nh.update('b')\nprint h.hexdigest()[:6]\n"
                    "print md5.new('ab').hexdigest()[:6], binascii.hexlify('ab')\n"
                    "print base64.b64encode('abc'), base64.b64decode('YWJj') + '.'\n",
                    "187ef4", "187ef4 6162", "YWJj abc.")

    def testWhatTheProgramDoesWrongIsItsOwnError(self):
        self.run_("class A:\n    def write(self, text): return text + 1\n"
                  "print A().write('a')\n", code=1)
        self.assertEqual(self.errors.count("in write"), 1)

    def testLostModulesAndFunctionsAreThere(self):
        self.prints("import threading, collections, fractions, sets, types, new, inspect\n"
                    "from email.MIMEText import MIMEText\nfrom UserDict import UserDict\n"
                    "import exceptions, os\n"
                    "t = threading.Thread(target=lambda: None)\nprint t.isAlive()\n"
                    "print isinstance({}, collections.Mapping), fractions.gcd(4, 6), "
                    "len(sets.Set([1, 1]))\n"
                    "print type('a') == types.StringType, isinstance(u'a', types.StringTypes), "
                    "exceptions.ValueError is ValueError\n"
                    "print inspect.getargspec(lambda a, b=1: a).args, UserDict({1: 2})[1]\n"
                    "print 'abc'.translate(None, 'b'), MIMEText('x').get_payload()\n",
                    "False", "True 2 1", "True True True", "['a', 'b'] 2", "ac x")

    def testNumbersAreRoundedAwayFromZero(self):
        self.prints("print round(2.5), round(-0.5), round(3.14159, 2), round(1234, -2), "
                    "round(2.675, 2)\n", "3.0 -1.0 3.14 1200.0 2.67")

    def testTextIsRunAsPython2(self):
        self.write("other.py", "print 'other', 7 / 2\nfound = 1\n")
        self.prints("execfile('other.py')\nprint found\nexec 'print 3 / 2'\n"
                    "names = {}\nexec 'x = `4`' in names\nprint names['x']\n",
                    "other 3", "1", "1", "4")

    def testANameMayBeAKeywordOfToday(self):
        self.prints("async = 3\ndef f(async=1): return async\nprint async, f(async=2)\n"
                    "await = 'async'\nprint await\n", "3 2", "async")

    def testOldCallsOfOldNames(self):
        self.prints("import commands, thread, os, string\n"
                    "print commands.getoutput('echo hi'), os.getcwdu() == os.getcwd()\n"
                    "lock = thread.allocate_lock()\nlock.acquire()\n"
                    "thread.start_new_thread(lambda: lock.release(), ())\nlock.acquire()\n"
                    "print unichr(65), string.letters[26:28], string.lstrip(' a'), 10L\n"
                    "f = open('f', 'w')\nprint >>f, 'line', 1\nf.close()\n"
                    "print open('f').next().strip(), iter([5]).next(), callable(raw_input)\n",
                    "hi True", "A AB a 10", "line 1 5 True")


if __name__ == "__main__":
    unittest.main()
