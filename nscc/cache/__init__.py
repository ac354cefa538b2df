"""The user's cache: a folder of small files that may be deleted at any time.

It keeps the parser's tables and search results, never a proof: words from the cache are proved like
any others. A damaged or unreadable file is ignored and written again.
"""
