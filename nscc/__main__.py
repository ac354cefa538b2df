"""`python -m nscc` is `nscc`."""

from __future__ import annotations

import sys

from nscc.cli.main import main

sys.exit(main())
