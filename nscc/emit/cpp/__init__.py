"""C++ for the SCAMP-5d and SCAMP-7 devkits, generated from the words of a compiled program."""
