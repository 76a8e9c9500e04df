"""python3 -m usarnaoqi_sdk.python2 SCRIPT.py [arguments]: exit code 2 if it can not be converted.
The copies are in the folder USARNAOQI_PY2_FOLDER if there is one, else in one that ends with the
program."""

import contextlib
import os
import sys
import tempfile
import types
from typing import Any

from . import aliases, loader
from .translate import NoTranslator


def main() -> None:
    script = sys.argv[1]
    with _folder() as folder:
        try:
            copies = loader.Copies(folder)
            code = copies.compiled(script)
            sys.path[0] = os.path.dirname(os.path.abspath(script))
            loader.install(copies, script)  # before anything is written: that may be a wait
        except (NoTranslator, OSError, SyntaxError) as error:
            sys.exit(_told("%s" % error))
        _told("%s: Python 2, converted by %s into a temporary copy, %s" % (
            script, copies.translator.name, code.co_filename))
        aliases.install()
        _run(script, code)


def _folder() -> Any:
    given = os.environ.get("USARNAOQI_PY2_FOLDER")
    if given:
        return contextlib.nullcontext(given)
    return tempfile.TemporaryDirectory(prefix="usarnaoqi-py2-")


def _told(text: str) -> int:
    sys.stderr.write("usarnaoqi: %s\n" % text)
    return 2


def _run(script: str, code: types.CodeType) -> None:
    """As `python script.py` would."""
    del sys.argv[0]
    module = types.ModuleType("__main__")
    module.__file__ = script
    module.__dict__["__builtins__"] = __builtins__
    sys.modules["__main__"] = module
    exec(code, module.__dict__)  # pylint: disable=exec-used  # the user's program


if len(sys.argv) < 2:
    sys.exit("usarnaoqi_sdk.python2: which script?")
main()
