"""One layer for every TOML file: keys declared once, read, explained, changed and written.

Targets, sensors and training runs are each a `Schema` of `Key` rows. A library was looked for and
not found: msgspec stops at the first fault; pydantic and cattrs collect them all, but none of the
three knows the line that a value stands in, the name that was probably meant, or how to write a
commented file. They would save no more than `kinds`, and cost every start (`nscc check` reads a
target) a sixth of `import numpy` (msgspec), a half (cattrs) or more than all of it (pydantic).
"""
