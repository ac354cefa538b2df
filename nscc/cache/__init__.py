"""The user's cache: a folder of small files that may be deleted at any time.

It contains the parser's tables and search results, but no proofs: words from the cache are proved
again. A damaged or unreadable file is ignored and replaced."""
