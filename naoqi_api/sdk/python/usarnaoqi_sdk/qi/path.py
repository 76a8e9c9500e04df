"""qi.path: where an application's files are, below ~/.local/share and ~/.config."""

import os
from typing import List


def _below(variable: str, default: str, *parts: str) -> str:
    base = os.environ.get(variable) or os.path.join(os.path.expanduser("~"), default)
    return os.path.join(base, *parts)


def sdkPrefix() -> str:
    return ""


def sdkPrefixes() -> List[str]:
    return []


def userWritableDataPath(application: str, filename: str = "") -> str:
    return _below("XDG_DATA_HOME", ".local/share", application, filename)


def userWritableConfPath(application: str, filename: str = "") -> str:
    return _below("XDG_CONFIG_HOME", ".config", application, filename)


def dataPaths(application: str = "") -> List[str]:
    return [userWritableDataPath(application)]


def confPaths(application: str = "") -> List[str]:
    return [userWritableConfPath(application)]


def findData(application: str, filename: str) -> str:
    """The file, or "" if there is none."""
    return _existing(userWritableDataPath(application, filename))


def findConf(application: str, filename: str) -> str:
    return _existing(userWritableConfPath(application, filename))


def listData(application: str, pattern: str = "*") -> List[str]:
    import glob
    return sorted(glob.glob(userWritableDataPath(application, pattern)))


def _existing(path: str) -> str:
    return path if os.path.exists(path) else ""
