"""The entry point of the command `nscc`, and of `python -m nscc_cli`."""

from __future__ import annotations

import sys


def main() -> int:
    """Run `nscc` with the arguments of the process and return the exit status. It is 130 if Ctrl-C
    comes while modules are imported, too: `nscc_cli.main` handles later interrupts."""
    try:
        from nscc_cli.main import main as run

        return run()
    except KeyboardInterrupt:
        sys.stderr.write("\ninterrupted\n")
        return 130


if __name__ == "__main__":
    sys.exit(main())
