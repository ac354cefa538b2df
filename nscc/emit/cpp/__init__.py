"""C++ for the SCAMP-5d and SCAMP-7 devkits, generated from the words of a compiled program."""

from nscc.emit.cpp.program import DevkitProgram, devkit_program

__all__ = ["DevkitProgram", "devkit_program"]
