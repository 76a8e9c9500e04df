"""Where a program is sent to, whatever address is written into it."""

import os
import unittest
from unittest import mock

import support  # noqa: F401  # finds the package
from usarnaoqi_sdk import address as addresses


class AddressTest(unittest.TestCase):
    def setUp(self):
        patch = mock.patch.object(addresses, "_named", [])
        patch.start()
        self.addCleanup(patch.stop)

    def of(self, *asked, **variables):
        with mock.patch.dict(os.environ, variables):
            if not variables:
                os.environ.pop("NAOQI_ADDRESS", None)
            return addresses.address(*asked)

    def testIsWhatTheProgramSaysUnlessTheEnvironmentSaysOtherwise(self):
        self.assertEqual(self.of("10.0.0.1", 9560), "10.0.0.1:9560")
        self.assertEqual(self.of(), "127.0.0.1:9559")
        self.assertEqual(self.of("10.0.0.1", 9560, NAOQI_ADDRESS="tcp://nao:5"), "nao:5")
        self.assertEqual(self.of("10.0.0.1", 9560, NAO_IP="nao", NAOQI_ADDRESS=""), "nao:9560")

    def testSeveralRobotsAreToldApartByPort(self):
        two = "127.0.0.1:5,127.0.0.1:6"
        self.assertEqual(self.of("nao", 9559, NAOQI_ADDRESS=two), "127.0.0.1:5")
        self.assertEqual(self.of("nao", 9560, NAOQI_ADDRESS=two), "127.0.0.1:6")
        self.assertEqual(self.of(None, None, NAOQI_ADDRESS=two), "127.0.0.1:5")

    def testOrByTheHostsInTheOrderInWhichTheyAreNamed(self):
        three = "a:1,b:2,c:3"
        hosts = ["first", "second", "first", "third", "fourth", ""]
        found = [self.of(host, 9559, NAOQI_ADDRESS=three) for host in hosts]
        self.assertEqual(found, ["a:1", "b:2", "a:1", "c:3", "c:3", "a:1"])

    def testThisMachineIsOneHostWhateverItIsCalled(self):
        two = "127.0.0.1:5,127.0.0.1:6"
        for host in ("localhost", "127.0.0.1", "0.0.0.0", "Localhost"):
            self.assertEqual(self.of(host, 9559, NAOQI_ADDRESS=two), "127.0.0.1:5", host)
        self.assertEqual(self.of("nao.local", 9559, NAOQI_ADDRESS=two), "127.0.0.1:6")

    def testPortsFarFromTheUsualOneTellRobotsApartToo(self):
        found = [self.of("127.0.0.1", port, NAOQI_ADDRESS="a:1,b:2") for port in
                 (38001, 38002, 38001)]
        self.assertEqual(found, ["a:1", "b:2", "a:1"])


if __name__ == "__main__":
    unittest.main()
