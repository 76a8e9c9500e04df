"""Values, signatures and frames, byte by byte."""

import math
import unittest

from support import Kind, findRecorded, recordedConversation
from usarnaoqi_sdk.decoding import decode
from usarnaoqi_sdk.encoding import Typed, encode
from usarnaoqi_sdk.errors import ConversionError, DecodeError
from usarnaoqi_sdk.message import Splitter
from usarnaoqi_sdk.metaobject import SIGNATURE, MetaObject
from usarnaoqi_sdk.signature import parse

SERVICE_INFO = ("(sIsI[s]ss)<ServiceInfo,name,serviceId,machineId,processId,endpoints,sessionId,"
                "objectUid>")


class Signature(unittest.TestCase):
    def testNestsAndKeepsAnnotations(self):
        node = parse("[(sI[s])<Info,name,id,endpoints>]")
        self.assertEqual(node.items[0].fields, ("name", "id", "endpoints"))
        self.assertEqual([item.kind for item in node.items[0].items], ["s", "I", "["])

    def testAnnotationsMayNest(self):
        self.assertEqual(parse("(i)<Pair<int,x>,first>").kind, "(")

    def testRefusesWhatIsNotExactlyOneType(self):
        for text in ("", "ii", "[", "[]", "[ii]", "{s}", "{sii}", "(i", "i)", "q", "(i)<Name", "+"):
            with self.subTest(text), self.assertRaises(DecodeError):
                parse(text)

    def testRefusesEndlessNesting(self):
        with self.assertRaises(DecodeError):
            parse("[" * 100000)


class Values(unittest.TestCase):
    CASES = [
        ("b", True, "01"), ("c", -1, "ff"), ("W", 0x1234, "3412"), ("i", -2, "feffffff"),
        ("L", 1 << 63, "0000000000000080"), ("f", 0.5, "0000003f"),
        ("d", 2.5, "0000000000000440"), ("s", "hé", "0300000068c3a9"), ("r", b"\0\1", "020000000001"),
        ("[f]", [0.25, 1.0], "020000000000803e0000803f"), ("[i]", [], "00000000"),
        ("{si}", {"a": 1}, "01000000" "0100000061" "01000000"),
        ("(ib)", (7, False), "0700000000"), ("v", None, ""), ("+i", None, "00"),
        ("+i", 3, "0103000000"), ("m", None, "01000000" "76"),
        ("m", 7, "010000006c" "0700000000000000"), ("m", "x", "0100000073" "0100000078"),
        ("m", True, "0100000062" "01"), ("m", (), "020000002829"),
    ]

    def testHaveTheirBytes(self):
        for signature, value, text in self.CASES:
            with self.subTest(signature=signature, value=value):
                self.assertEqual(encode(signature, value).hex(), text)
                self.assertEqual(decode(signature, bytes.fromhex(text)), value)

    def testDynamicsRoundTrip(self):
        value = [1, "x", 2.5, True, None, {"k": [1, 2]}, (1, 2), {3: {}}, [[[]]]]
        self.assertEqual(decode("m", encode("m", value)), value)

    def testTypedOverridesTheNaturalSignature(self):
        self.assertEqual(encode("m", Typed("I", 113)).hex(), "0100000049" "71000000")

    def testAnEmptySignatureIsNoValue(self):
        self.assertIsNone(decode("m", bytes(4)))

    def testTextThatIsNotUtf8KeepsItsBytes(self):
        data = bytes.fromhex("02000000" "ff80")
        self.assertEqual(encode("s", decode("s", data)), data)

    def testNotANumberPasses(self):
        self.assertTrue(math.isnan(decode("f", encode("f", math.nan))))

    def testWhatDoesNotFitIsRefused(self):
        for signature, value in (("i", 1 << 31), ("I", -1), ("i", "1"), ("(ii)", (1,)),
                                 ("[i]", ["a"]), ("m", object()), ("o", None), ("f", 1e39)):
            with self.subTest(signature=signature, value=value):
                with self.assertRaises(ConversionError):
                    encode(signature, value)


class BadBytes(unittest.TestCase):
    def testEveryTruncationIsADecodeError(self):
        signature, value = "(s[(if)]{sm}r+im)", ("a", [(1, 2.0)], {"k": [1, "x"]}, b"raw", 4, "end")
        data = encode(signature, value)
        for size in range(len(data)):
            with self.subTest(size), self.assertRaises(DecodeError):
                decode(signature, data[:size])

    def testBytesTooManyAreADecodeError(self):
        with self.assertRaises(DecodeError):
            decode("i", bytes(5))

    def testHugeCountsAllocateNothing(self):
        for signature in ("[i]", "[s]", "[v]", "[()]", "{vv}", "[[v]]", "s", "r"):
            with self.subTest(signature), self.assertRaises(DecodeError):
                decode(signature, b"\xff\xff\xff\xff")

    def testDynamicsCannotNestForEver(self):
        with self.assertRaises(DecodeError):
            decode("m", b"\1\0\0\0m" * 100000)

    def testAMapKeyedByAListIsADecodeError(self):
        with self.assertRaises(DecodeError):
            decode("{[i]i}", encode("(I[i]i)", (1, [], 0)))

    def testAnObjectWithoutASessionIsADecodeError(self):
        with self.assertRaises(DecodeError):
            decode("o", bytes(40))


class Frames(unittest.TestCase):
    def testRecordedMessagesRoundTrip(self):
        conversation = recordedConversation()
        self.assertEqual(len(conversation), 77)
        for entry in conversation:
            self.assertEqual(entry.message.toBytes(), entry.data)

    def testAnyCutOfTheStreamGivesTheSameMessages(self):
        conversation = recordedConversation()[10:20]
        stream = b"".join(entry.data for entry in conversation)
        expected = [entry.message for entry in conversation]
        for step in (1, 7, 28, 1000):
            splitter, messages = Splitter(), []
            for start in range(0, len(stream), step):
                messages += splitter.feed(stream[start:start + step])
            self.assertEqual(messages, expected)

    def testGarbageIsADecodeError(self):
        with self.assertRaises(DecodeError):
            Splitter().feed(b"GET / HTTP/1.1\r\nHost: a-robot\r\n\r\n")

    def testAnOversizedMessageIsRefusedFromItsHeaderAlone(self):
        header = bytearray(findRecorded("C", Kind.CALL, 100).toBytes()[:28])
        header[8:12] = b"\xff\xff\xff\x7f"
        with self.assertRaises(DecodeError):
            Splitter().feed(bytes(header))


class RecordedPayloads(unittest.TestCase):
    """Bytes that a real client and a real server sent are the bytes this codec makes."""

    def check(self, signature, message, expected=None):
        value = decode(signature, message.payload)
        if expected is not None:
            self.assertEqual(value, expected)
        self.assertEqual(encode(signature, value), message.payload)

    def testTheOpening(self):
        request = findRecorded("C", Kind.CALL, 8)
        self.check("{sm}", request, {
            "ClientServerSocket": True, "MessageFlags": True, "MetaObjectCache": False,
            "ObjectPtrUID": True, "RelativeEndpointURI": True, "RemoteCancelableCalls": True})
        self.assertEqual(decode("{sm}", findRecorded("S", Kind.REPLY, 8).payload)["__qi_auth_state"],
                         3)

    def testServiceInfo(self):
        message = findRecorded("S", Kind.REPLY, 100)
        self.check(SERVICE_INFO, message)
        self.assertEqual(decode(SERVICE_INFO, message.payload)[:2], ("Demo", 2))

    def testMetaObjects(self):
        for nth, methods in ((0, 22), (1, 26)):
            message = findRecorded("S", Kind.REPLY, 2, nth)
            self.check(SIGNATURE, message)
            self.assertEqual(len(MetaObject(decode(SIGNATURE, message.payload)).methods), methods)

    def testCallsAndReplies(self):
        self.check("([s]b)", findRecorded("C", Kind.CALL, 105), (["HeadYaw", "HeadPitch"], True))
        self.check("[f]", findRecorded("S", Kind.REPLY, 105), [0.25, 0.25])
        self.check("(m)", findRecorded("C", Kind.CALL, 104),
                   ([1, "x", 2.5, True, None, {"k": [1, 2]}, (1, 2)],))
        self.check("{si}", findRecorded("S", Kind.REPLY, 106), {"a": 1, "b": 2})
        self.check("r", findRecorded("S", Kind.REPLY, 107), b"\1\2\3\4")
        self.check("m", findRecorded("S", Kind.ERROR, 108), "deliberate failure")
        self.check("(is)", findRecorded("S", Kind.EVENT, 112), (5, "tick"))


if __name__ == "__main__":
    unittest.main()
