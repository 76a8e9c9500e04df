"""Which overload a call means, and what its arguments become."""

import unittest

from support import Kind, findRecorded
from usarnaoqi_sdk.conversion import convert
from usarnaoqi_sdk.decoding import decode
from usarnaoqi_sdk.errors import CallError, ConversionError
from usarnaoqi_sdk.metaobject import SIGNATURE, MetaObject


def metaObject(*methods):
    """A metaobject of (name, argument signature) pairs, numbered from 100."""
    entries = {uid: (uid, "v", name, arguments, "", [], "")
               for uid, (name, arguments) in enumerate(methods, 100)}
    return MetaObject((entries, {}, {}, ""))


class FakeArray:
    """As numpy's arrays: known by tolist() alone."""

    def tolist(self):
        return [1, 2]


class Convert(unittest.TestCase):
    def testNumbersConvertLikeARealClientConverts(self):
        for signature, value, expected in (
                ("f", 1, 1.0), ("i", 1.7, 1), ("i", -2.7, -2), ("i", True, 1), ("b", 1, True),
                ("b", 0.0, False), ("[f]", (1, 2), [1.0, 2.0]), ("[f]", [], []), ("d", 3, 3.0),
                ("[f]", FakeArray(), [1.0, 2.0]), ("m", FakeArray(), [1, 2]), ("r", b"x", b"x")):
            with self.subTest(signature=signature, value=value):
                converted = convert(signature, value)
                self.assertEqual(converted, expected)
                self.assertIs(type(converted), type(expected))

    def testStructsTakeTheirFieldsByName(self):
        self.assertEqual(convert("(if)<Point,x,y>", {"y": 2, "x": 1}), (1, 2.0))

    def testWhatARealServerRefusesIsRefused(self):
        for signature, value in (("i", 1 << 40), ("I", -1), ("b", 5), ("b", 0.5), ("s", 3),
                                 ("i", "3"), ("i", None), ("[s]", "one"), ("[s]", [1]),
                                 ("f", 1e39), ("i", float("nan")), ("m", object()),
                                 ("m", 1 << 64), ("{si}", [1])):
            with self.subTest(signature=signature, value=value):
                with self.assertRaises(ConversionError):
                    convert(signature, value)


class Choose(unittest.TestCase):
    def testRecordedOverloadsAreChosenAsTheRealClientDid(self):
        meta = MetaObject(decode(SIGNATURE, findRecorded("S", Kind.REPLY, 2, 1).payload))
        for arguments, signature in (((1, 2), "(ii)"), ((1.5, 2.5), "(ff)"), ((1, 2.5), "(ff)")):
            self.assertEqual(meta.choose("add", arguments).arguments, signature)

    def testNaoQisOverloadsAreToldApart(self):
        meta = metaObject(("insertData", "(si)"), ("insertData", "(sf)"), ("insertData", "(ss)"),
                          ("insertData", "(sm)"), ("setAngles", "(mmf)"), ("setAngles", "(mm[f])"),
                          ("moveTo", "(fff)"), ("moveTo", "(ffff)"), ("moveTo", "(fffm)"),
                          ("moveTo", "(m)"), ("say", "(s)"), ("say", "(ss)"))
        for name, arguments, signature in (
                ("insertData", ("k", 1), "(si)"), ("insertData", ("k", 1.5), "(sf)"),
                ("insertData", ("k", "v"), "(ss)"), ("insertData", ("k", [1]), "(sm)"),
                ("setAngles", ("HeadYaw", 1, 0.1), "(mmf)"),
                ("setAngles", (["HeadYaw"], [1], [0.1]), "(mm[f])"),
                ("moveTo", (1, 0, 0), "(fff)"), ("moveTo", (0.3, 0, 0, 2), "(ffff)"),
                ("moveTo", (0.3, 0, 0, [["MaxStepX", 0.04]]), "(fffm)"),
                ("moveTo", ([[0.1, 0, 0]],), "(m)"), ("say", ("a",), "(s)")):
            with self.subTest(name=name, arguments=arguments):
                self.assertEqual(meta.choose(name, arguments).arguments, signature)

    def testAFullNameMeansExactlyThatOverload(self):
        meta = metaObject(("add", "(ii)"), ("add", "(ff)"))
        self.assertEqual(meta.choose("add::(ff)", (1, 2)).arguments, "(ff)")

    def testASingleCandidateIsTakenUnchecked(self):
        self.assertEqual(metaObject(("f", "([s])")).choose("f", ("text",)).arguments, "([s])")

    def testNoCandidateNamesTheSignatureOfTheCall(self):
        with self.assertRaisesRegex(CallError, r"Can't find method: f \(resolved to '\(bds\)'\)"):
            metaObject(("f", "(s)")).choose("f", (True, 1.5, "x"))

    def testTwoEquallyGoodCandidatesAreAmbiguous(self):
        with self.assertRaisesRegex(CallError, "Ambiguous"):
            metaObject(("f", "(i)"), ("f", "(l)")).choose("f", (1,))

    def testNoFittingCandidateListsThem(self):
        with self.assertRaisesRegex(CallError, r"Arguments types did not match.*\n.*f::\(i\)"):
            metaObject(("f", "(i)"), ("f", "(b)")).choose("f", ("x",))


if __name__ == "__main__":
    unittest.main()
