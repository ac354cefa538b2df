"""runtime/PROTOCOL.md says what the code does: kinds, faults, states, sizes, numbers."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from loader_twin.intake import MOST_OBJECTS
from loader_twin.loader import MOST_READS

from nscc_runtime.device import messages, objects, packets


@pytest.fixture(scope="module")
def page(root: Path) -> str:
    """The page."""
    return (root / "runtime/PROTOCOL.md").read_text()


def test_the_page_lists_all_kinds_of_packets(page: str) -> None:
    listed = {int(n, 16): name for n, name in re.findall(r"^\| 0x(\w\w) ([A-Z_]+) ", page, re.M)}
    assert listed == {kind.value: kind.name for kind in packets.PacketKind}


def test_the_page_lists_all_faults_of_the_loader(page: str) -> None:
    listed = re.findall(r"^\| (\d+) \| (.+?) \| .*\|$", page.split("## Faults")[1], re.M)
    numbers = [int(number) for number, _ in listed[: len(messages.LoaderFault)]]
    assert numbers == [fault.value for fault in messages.LoaderFault]
    for (_, text), fault in zip(listed, messages.LoaderFault, strict=False):
        assert fault.name.lower().split("_")[0] in text, fault


def test_the_page_lists_all_states_of_the_loader(page: str) -> None:
    [line] = re.findall(r"Numbers in INFO, STATUS and PROGRESS: (.*?)\. HELLO", page, re.S)
    listed = {name: int(number) for name, number in re.findall(r"([A-Z]+) (\d)", line)}
    assert listed == {state.name: state.value for state in messages.LoaderState}


def test_the_page_lists_all_kinds_of_objects(page: str) -> None:
    listed = re.findall(r"^\| (\d) \| ([A-Z]+) \| ", page, re.M)
    assert listed == [(str(kind.value), kind.name) for kind in objects.ObjectKind]


WIDTHS = {"u8": 1, "u16": 2, "u32": 4, "u64": 8, "f64": 8}


@pytest.mark.parametrize("name", ["STATUS", "PROGRESS", "CAPTURED", "ENTRY"])
def test_bodies_are_as_long_as_their_descriptions(page: str, name: str) -> None:
    [text] = re.findall(rf"^\*\*{name}\*\*: (.*?)\n\n", page, re.M | re.S)
    text = re.sub(r"\(.*?\)", "", text, flags=re.S)
    size = 0
    for item in re.sub(r"\.$", "", " ".join(text.split())).split(","):
        first = item.split()[0]
        size += WIDTHS[first] if first in WIDTHS else int(first)
    kinds = {
        "STATUS": messages.Status,
        "PROGRESS": messages.UploadProgress,
        "CAPTURED": messages.CaptureReply,
        "ENTRY": messages.ObjectEntry,
    }
    assert size == kinds[name].layout.size


def test_the_page_states_the_limits_of_the_code(page: str) -> None:
    limits = page.split("## Limits")[1]
    for name, value in (
        ("body of a packet", packets.MOST_BODY),
        ("DATA, FRAME", packets.MOST_DATA),
        ("objects of a program", MOST_OBJECTS),
        ("READs that wait", MOST_READS),
    ):
        assert re.search(rf"^\| {name} \| {value}\b", limits, re.M), name
    assert objects.MOST_LAUNCHES == 1 << 20
    assert f"longer than {packets.OVERHEAD + packets.MOST_BODY} bytes" in " ".join(page.split())
    assert f"at most {messages.MOST_ENTRIES}" in page
