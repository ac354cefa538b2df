"""A chip behind a serial line: protocol, host, and a stand-in for the chip.

`runtime/PROTOCOL.md` describes the protocol. `host.py` does no I/O: it maps bytes and time to
bytes. Only `port.py` imports serial."""
