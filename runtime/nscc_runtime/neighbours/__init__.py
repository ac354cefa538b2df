"""What follows the last slot of a program of version 3: words that reach neighbouring pixels."""
