"""Studies of `nscc tradeoff`: error against time."""
