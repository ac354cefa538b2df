"""`python -m nscc_cli` is `nscc`."""

from __future__ import annotations

import sys

from nscc_cli.main import main

sys.exit(main())
