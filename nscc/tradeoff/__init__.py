"""What more time buys: measured points of error against time, and what is made of them."""
