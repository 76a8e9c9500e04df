"""Runs Python 2 programs: `python3 -m usarnaoqi_sdk.python2 script.py arguments...` converts the
script, and every module of the user's that it imports, when it is needed. The converted text goes
to a temporary folder, which lasts as long as the program; the sources are left alone."""
