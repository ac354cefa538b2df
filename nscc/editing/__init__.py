"""Services for editors: what a program's text means while it is written.

from nscc.editing.document import Document
    from nscc.editing.hover import hover

document = Document("a.nsl", text, folder)
    document.checked.diagnostics    # those of `nscc check`
    hover(document, offset)         # what stands at a character, in words

Places are character offsets, as in `nscc.source`. Every function takes any text whatever, finished
or not, and none raises for it unless it says so.
"""
