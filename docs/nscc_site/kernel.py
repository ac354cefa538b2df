"""What every notebook's kernel runs first: how `!command` behaves in it."""

import subprocess

from IPython import get_ipython


def system(command: str) -> None:
    """Print what the command says, in its order, as if to a file; if it fails, so does the cell."""
    expanded = get_ipython().var_expand(command, depth=1)
    done = subprocess.run(
        expanded, shell=True, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
    )
    print(done.stdout, end="")
    done.check_returncode()


get_ipython().system = system
