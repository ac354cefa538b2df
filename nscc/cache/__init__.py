"""What is kept from one run to the next: a folder of small files that may vanish any time.

Kept are the parser's tables and what searches found, never a proof: words that come from here are
proved like any others. A file that is damaged, unreadable or not what it says is passed over and
written anew.
"""
