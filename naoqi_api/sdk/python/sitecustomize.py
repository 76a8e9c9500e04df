"""With this folder on PYTHONPATH every Python 3 started finds `naoqi`, `qi` and the others. Python
looks for one sitecustomize only, so the next one on the path, the user's own, is run from here."""

import sys


def _offer():
    if sys.version_info < (3, 8):
        sys.stderr.write("usarnaoqi: naoqi and qi are offered to Python 3.8 and later, not to this "
                         "Python %d.%d\n" % sys.version_info[:2])
        return
    from usarnaoqi_sdk import finder
    finder.install()


def _runNext():
    import os
    here = os.path.dirname(os.path.abspath(__file__))
    for folder in sys.path:
        path = os.path.join(folder, "sitecustomize.py")
        if os.path.abspath(folder or ".") != here and os.path.isfile(path):
            names = {"__name__": "sitecustomize", "__file__": path}
            with open(path, "rb") as file:
                exec(compile(file.read(), path, "exec"), names)
            return


_offer()
_runNext()
