"""The command line: parses options, calls functions of the lower packages, and prints results.

It imports nscc, nscc_runtime and nscc_training, each only when a command needs it. No other
package imports nscc_cli, except commands of other distributions, which use `nscc_cli.support`."""
