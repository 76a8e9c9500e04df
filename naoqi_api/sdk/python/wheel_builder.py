"""Lets `pip install naoqi_api/sdk/python` work without a network: makes the wheel, a zip file of
the modules and three lines of metadata (Python's PEP 427 and PEP 517). A .pth file, which Python
reads at its start, lets every program find `naoqi`, `qi` and the others."""

import base64
import hashlib
import os
import zipfile

NAME, VERSION = "usarnaoqi_sdk", "0.1"
PACKAGES = ["usarnaoqi_sdk", "usarnaoqi_behavior"]
START = ("usarnaoqi_sdk.pth", b"import usarnaoqi_sdk.finder; usarnaoqi_sdk.finder.install()\n")
INFO = "%s-%s.dist-info" % (NAME, VERSION)
# pytest finds its plug-in by this.
ENTRY_POINTS = "[pytest11]\nusarnaoqi = usarnaoqi_sdk.pytest_plugin\n"
METADATA = """Metadata-Version: 2.1
Name: usarnaoqi-sdk
Version: %s
Summary: A Nao's services from pure Python, over the robot's own wire
License: Apache-2.0
Requires-Python: >=3.8
""" % VERSION
WHEEL = """Wheel-Version: 1.0
Generator: usarnaoqi
Root-Is-Purelib: true
Tag: py3-none-any
"""


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """The hook that pip calls, in this folder; returns the wheel's file name."""
    files = {path: _read(path) for path in _packageFiles()}
    files[START[0]] = START[1]
    files[INFO + "/entry_points.txt"] = ENTRY_POINTS.encode()
    files[INFO + "/METADATA"] = METADATA.encode()
    files[INFO + "/WHEEL"] = WHEEL.encode()
    record = "".join("%s,sha256=%s,%d\n" % (path, _digest(data), len(data))
                     for path, data in files.items())
    files[INFO + "/RECORD"] = (record + INFO + "/RECORD,,\n").encode()
    name = "%s-%s-py3-none-any.whl" % (NAME, VERSION)
    with zipfile.ZipFile(os.path.join(wheel_directory, name), "w") as wheel:
        for path, data in files.items():
            wheel.writestr(path, data)
    return name


def _packageFiles():
    return sorted("%s/%s" % (folder, name) for package in PACKAGES
                  for folder, _, names in os.walk(package)
                  for name in names if name.endswith(".py"))


def _read(path):
    with open(path, "rb") as file:
        return file.read()


def _digest(data):
    digest = hashlib.sha256(data).digest()
    return base64.urlsafe_b64encode(digest).rstrip(b"=").decode("ascii")
