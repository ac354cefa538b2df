"""A page to try nscc: the requests of the page, its files, and the pages of the site."""
