"""The serial port. No other module imports serial."""

from __future__ import annotations

import errno
import os
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

_MOST_READ = 1 << 16


@dataclass(eq=False)
class PortTrouble(Exception):
    """A port cannot be opened. `kind`: "missing", "forbidden", "busy", "unsuited" (no serial port),
    "baud" (its speed) or "other". `reason`: a text."""

    kind: str
    reason: str


class PortGone(Exception):
    """An open port was lost."""


@dataclass
class Port:
    """An open serial port with non-blocking methods."""

    serial: Any

    def fileno(self) -> int:
        """Return the file descriptor, for select."""
        return int(self.serial.fileno())

    def read(self) -> bytes:
        """Return the received bytes, at most 65536; empty if there are none. Raises PortGone if the
        port is lost.

        Call it when select reports the port as readable: a port that is readable without bytes is
        lost."""
        try:
            data = os.read(self.fileno(), _MOST_READ)
        except BlockingIOError:
            return b""
        except (OSError, TypeError) as error:
            raise PortGone(str(error)) from None
        if not data:
            raise PortGone("end of file")
        return data

    def write(self, data: bytes) -> int:
        """Write `data` and return how many of its bytes, from the start, were accepted; 0 if none
        can be written now. Raises PortGone if the port is lost."""
        try:
            return os.write(self.fileno(), data)
        except BlockingIOError:
            return 0
        except (OSError, TypeError) as error:
            raise PortGone(str(error)) from None

    def close(self) -> None:
        """Close the port, in any state."""
        with suppress(OSError):
            self.serial.close()


def open_port(path: str, baud: int) -> Port:
    """Open the port at `path` exclusively, with `baud` bits per second, 8 data bits, no parity and
    1 stop bit.

    Raises PortTrouble with the kind of trouble if that fails; ImportError without pyserial."""
    import serial

    try:
        opened = serial.Serial(
            path, baudrate=baud, timeout=0, write_timeout=0, exclusive=True, rtscts=False
        )
        os.set_blocking(opened.fileno(), False)
    except ValueError as error:
        raise PortTrouble("baud", str(error)) from None
    except OSError as error:  # pyserial's SerialException is an OSError
        raise _trouble(error) from None
    return Port(opened)


def _trouble(error: OSError) -> PortTrouble:
    """Return the trouble with a port that an operating-system error means: its kind by the number
    of the error, and a text."""
    number = error.errno
    if number in (errno.ENOENT, errno.ENXIO, errno.ENODEV, errno.ENOTDIR):
        return PortTrouble("missing", "the port does not exist")
    if number in (errno.EACCES, errno.EPERM):
        return PortTrouble("forbidden", "you have no permission to use it")
    if number in (errno.EAGAIN, errno.EWOULDBLOCK, errno.EBUSY):
        return PortTrouble("busy", "another program has it open")
    # For a file that is not a terminal, pyserial wraps the error of termios without its number.
    if number in (errno.ENOTTY, errno.EINVAL, errno.EISDIR) or "configure port" in str(error):
        return PortTrouble("unsuited", "it is not a serial port")
    return PortTrouble("other", os.strerror(number) if number else str(error))


def list_ports() -> list[tuple[str, str]]:
    """Return names and descriptions of this machine's serial ports, sorted by name; a description
    may be "". Raises ImportError without pyserial."""
    from serial.tools.list_ports import comports

    return sorted((port.device, port.description or "") for port in comports())
