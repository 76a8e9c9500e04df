#!/usr/bin/env python3
"""The robot speaks. Run with PYTHONPATH=naoqi_api/sdk/python; the address is optional."""

import sys

from naoqi import ALProxy

ip = sys.argv[1] if len(sys.argv) > 1 else "127.0.0.1"
port = int(sys.argv[2]) if len(sys.argv) > 2 else 9559

speech = ALProxy("ALTextToSpeech", ip, port)
speech.say("Hello, I am a simulated Nao.")  # returns when it has been said
