"""Declaration, reading, changing and writing of TOML files with a fixed set of keys.

Targets, sensors and training runs are each a `Schema` of `Key` rows. Existing libraries do not
suffice: msgspec stops at the first error; pydantic and cattrs collect errors, but none of the three
knows the line of a value, suggests similar names, or writes commented files. They would replace
only `kinds`, and slow every start (`nscc check` reads a target) by a sixth of the time of `import
numpy` (msgspec), a half (cattrs) or more than all of it (pydantic)."""
