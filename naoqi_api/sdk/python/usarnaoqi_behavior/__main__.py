"""python3 -m usarnaoqi_behavior FILE.xar [--address HOST:PORT]: exit code 1 if code in a box failed,
2 if the file is no behavior or no robot answers."""

import argparse
import logging
import signal
import sys

from usarnaoqi_sdk import ConnectionLost

from . import Behavior, ProjectError, loadProject


def main() -> int:
    parser = argparse.ArgumentParser(prog="usarnaoqi_behavior", description=__doc__)
    parser.add_argument("file", help="a behavior.xar")
    parser.add_argument("--address", default="127.0.0.1:9559", help="of the robot, HOST:PORT")
    arguments = parser.parse_args()
    logging.basicConfig(level=logging.INFO, format="%(name)s: %(message)s")
    logging.getLogger("RefactoringTool").setLevel(logging.WARNING)
    try:
        behavior = Behavior(loadProject(arguments.file), arguments.file, arguments.address)
        for number in (signal.SIGTERM, signal.SIGINT):
            signal.signal(number, lambda *_: behavior.stop())
        behavior.run()
    except (ProjectError, OSError, ConnectionLost) as error:
        print("usarnaoqi_behavior: %s" % error, file=sys.stderr)
        return 2
    return 1 if behavior.errors else 0


if __name__ == "__main__":
    sys.exit(main())
