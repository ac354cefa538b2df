"""The command line: the only place that knows the compiler and the runtime."""
