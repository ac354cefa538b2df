"""What is said about frames that no calibration can be made of. All of it ends in status 2."""

from __future__ import annotations

UNUSABLE, TOO_FEW, NOT_TRANSFER = "NS0757", "NS0758", "NS0759"
UNDETERMINED, NOT_A_LINE = "NS0791", "NS0792"
