"""Run nscc by `python -m nscc_cli`."""

from __future__ import annotations

import sys

from nscc_cli.main import main

sys.exit(main())
