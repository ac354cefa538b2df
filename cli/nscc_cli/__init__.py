"""The command line: reads options, calls what the three packages below offer, prints.

It imports nscc, nscc_runtime and nscc_training, each command when it is called; nobody imports it,
except commands of other distributions, which find in `nscc_cli.support` what nscc's own share.
"""
