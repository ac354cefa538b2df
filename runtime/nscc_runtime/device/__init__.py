"""A chip at the other end of a serial line: protocol, host side, and a stand-in for the chip.

`runtime/PROTOCOL.md` describes the protocol. The two ends, `host.py` and `loader.py`, do no I/O:
bytes and the time go in, bytes come out. `port.py` alone imports serial.
"""
