"""Draw the pictures that pages keep beside them, for those who read them as files."""

from __future__ import annotations

from nscc_site import REPOSITORY
from nscc_site.pictures import KEPT

for kept, draw in KEPT.items():
    (REPOSITORY / kept).write_bytes(draw(REPOSITORY))
    print(f"wrote {kept}")
