"""What editors are told of programs of version 3."""

from __future__ import annotations

import pytest
from checkout import ROOT

from nscc.editing.complete import complete
from nscc.editing.document import Document
from nscc.editing.hover import hover
from nscc.editing.mentions import alike, mention_at, mentions

EXAMPLES = ROOT / "examples"
NAMES = ("edges", "bright_spots", "motion_in_a_frame", "local_contrast")


def document_of(name: str) -> Document:
    path = EXAMPLES / f"{name}.nsl"
    return Document(path.name, path.read_text(), EXAMPLES)


@pytest.mark.parametrize("name", NAMES)
def test_every_place_can_be_asked(name: str) -> None:
    """Hovering and completion at every third character of a program with pictures raise nothing."""
    document = document_of(name)
    for offset in range(0, len(document.text), 3):
        hover(document, offset)
        complete(document, offset)


def test_hovering_over_a_kernel_shows_its_weights_as_a_grid() -> None:
    document = document_of("edges")
    found = hover(document, document.text.index("sx(exposure"))
    assert found is not None
    assert " 1  0 -1\n 2  0 -2   / 8\n 1  0 -1" in found.text


def test_hovering_over_an_image_shows_its_words_and_gains() -> None:
    document = document_of("edges")
    found = hover(document, document.text.index("strength >"))
    assert found is not None
    assert "words, peak gain 1, noise gain" in found.text


def test_buckets_and_kernels_are_found_by_their_names() -> None:
    """A bucket of version 3 is read by its name, and a kernel is called by its own."""
    document = document_of("motion_in_a_frame")
    mention = mention_at(document, document.text.index("late - early"))
    assert mention is not None
    assert len(alike(document, mention)) == 2
    calls = [each for each in mentions(document) if each.name == "blur"]
    assert [each.declares for each in calls] == [True, False]
