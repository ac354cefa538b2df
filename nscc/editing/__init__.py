"""Services for editors: the meaning of a program text, even while it is incomplete.

    from nscc.editing.document import Document
    from nscc.editing.hover import hover

    document = Document("a.nsl", text, folder)
    document.checked.diagnostics    # those of `nscc check`
    hover(document, offset)         # a description of the place at `offset`

Places are character offsets, as in `nscc.source`. All functions accept any text, also an invalid
one, and raise no error for it unless their docstring says so."""
