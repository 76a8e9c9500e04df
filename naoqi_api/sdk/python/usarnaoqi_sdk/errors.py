"""What can go wrong, as exceptions. All are RuntimeErrors, as client programs expect."""


class QiError(RuntimeError):
    """Any failure of this package."""


class CallError(QiError):
    """The call was refused, here or by the service; the text says why."""


class ConversionError(CallError):
    """An argument does not fit the declared type."""


class ConnectionLost(QiError):
    """The connection could not be made, or ended before the answer came."""


class DecodeError(QiError):
    """The bytes received are not what the protocol allows."""
