"""`--max-words-per-slot`, and what the messages about too many words in a slot name."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest
from nscc_command import invoke

from nscc.words.cost import kernel_cost
from nscc.words.file import read_container

STOPS = "nsl 1\nframe 16 slots of 1ms\ncode stop : 1..16\nopen when n < stop\n"
BOOK = np.unique(np.random.default_rng(7).integers(0, 2, (80, 16)), axis=0)[:64]
SEED = np.random.default_rng(8).permutation(64)


def book_program(rows, frame="frame 16 slots of 1ms", pixels="(x + 8 * y) % K"):
    """A codebook of these rows, all of them in use."""
    digits = ", ".join("".join(map(str, row)) for row in rows)
    return (
        f"nsl 1\n{frame}\nlet K = {len(rows)}\nshutters book [{digits}]\n"
        f"code id : row of book\nopen when book[id]\npixels id = {pixels}\n"
    )


def built(folder, text, *options):
    """What `nscc build` says of a program, as JSON messages, and its report if it was built."""
    (folder / "p.nsl").write_text(text)
    arguments = ["build", "p.nsl", "--emit", "report=-", "--message-format", "json", *options]
    outcome = invoke(arguments, folder)
    messages = [json.loads(line) for line in outcome.err.splitlines() if line.startswith("{")]
    return messages, json.loads(outcome.out) if outcome.status == 0 else None


def only_error(folder, text, *options):
    messages, report = built(folder, text, *options)
    assert report is None
    (error,) = (m for m in messages if m["severity"] == "error")
    return error


def within(report, words):
    """Whether every boundary of a built program stays within a limit."""
    return report is not None and report["words_per_slot"]["max"] <= words


@pytest.fixture(scope="module")
def rows():
    return BOOK[SEED].tolist()


@pytest.mark.slow
def test_a_limit_that_the_solution_meets_changes_nothing_in_the_report(tmp_path, rows):
    """With 24 rows, some solutions that the search finds before the cheapest one exceed the
    limit."""
    text = book_program(rows[:24])
    _, free = built(tmp_path, text)
    most = free["words_per_slot"]["max"]
    _, same = built(tmp_path, text, "--max-words-per-slot", str(most))
    assert same | {"alternatives": free["alternatives"]} == free


@pytest.mark.slow
def test_a_solution_within_the_limit_is_preferred_to_a_cheaper_one(tmp_path, rows):
    """The test lowers the limit by one below the words of each solution, until the compiler refuses
    the program."""
    text = book_program(rows)
    limit = built(tmp_path, text)[1]["words_per_slot"]["max"] - 1
    steps = 0
    while (report := built(tmp_path, text, "--max-words-per-slot", str(limit))[1]) is not None:
        assert within(report, limit)
        limit = report["words_per_slot"]["max"] - 1
        steps += 1
    error = only_error(tmp_path, text, "--max-words-per-slot", str(limit))
    assert error["code"] == "NS0603"
    assert error["data"]["required"] == limit + 1, "the message names the least that was found"
    assert error["data"]["available"] == limit


def check_rows(folder, error, text_of, limits):
    """Checks that a codebook of the K rows in the error compiles, and one of K + 1 does not."""
    count = error["data"]["rows"]
    assert re.search(rf"K = {count} +the first {count} of the ", error["rendered"])
    assert "compiled and fits" in error["rendered"]
    _, report = built(folder, text_of(count), *limits)
    assert report is not None
    assert built(folder, text_of(count + 1), *limits)[1] is None
    return report


def too_few_words(folder, text, share):
    """A limit between what every program needs for a start and the least found for `text`."""
    least = only_error(folder, text, "--max-words-per-slot", "8")["data"]["required"]
    return round(8 + share * (least - 9))


@pytest.mark.parametrize(
    ("count", "share"),
    [(24, 1.0), (64, 0.2), (64, 0.5), (64, 1.0)],
)
@pytest.mark.slow
def test_the_error_of_a_codebook_names_the_rows_that_pass(tmp_path, rows, count, share):
    rows = rows[:count]
    limit = too_few_words(tmp_path, book_program(rows), share)
    option = ("--max-words-per-slot", str(limit))
    error = only_error(tmp_path, book_program(rows), *option)
    assert (error["code"], error["name"]) == ("NS0603", "slot-too-full")
    report = check_rows(tmp_path, error, lambda count: book_program(rows[:count]), option)
    assert within(report, limit)


@pytest.mark.slow
def test_only_rows_in_use_count(tmp_path, rows):
    text = book_program(rows, pixels="2 * ((x + 8 * y) % 32) + 1")
    option = ("--max-words-per-slot", str(too_few_words(tmp_path, text, 0.6)))
    error = only_error(tmp_path, text, *option)
    used = rows[1::2]
    check_rows(tmp_path, error, lambda count: book_program(used[:count]), option)
    count = error["data"]["rows"]
    assert f"of the 32 rows in use, up to row {2 * count - 1}" in error["rendered"]


@pytest.mark.slow
def test_unequal_slots_and_buckets_keep_their_frame(tmp_path, rows):
    times = ", ".join(f"{1 + k % 3}.5ms" for k in range(16))

    def text(count):
        other = book_program(rows[:count], frame=f"frame slots [{times}]")
        turned = ", ".join("".join(map(str, row[::-1])) for row in rows[:count])
        return other.replace(
            "open when book[id]",
            f"shutters back [{turned}]\nbucket one open when book[id]\n"
            "bucket two open when back[id]",
        )

    option = ("--max-words-per-slot", str(too_few_words(tmp_path, text(64), 0.6)))
    check_rows(tmp_path, only_error(tmp_path, text(64), *option), text, option)


@pytest.mark.slow
def test_slots_too_short_for_a_codebook_name_the_rows_that_pass(tmp_path, rows):
    def text(count, slot_us=None):
        return book_program(rows[:count], frame=f"frame 16 slots of {slot_us or tight_us:.3f}us")

    certain = only_error(tmp_path, text(64, 2.0))["data"]
    assert certain["proved"]
    certain_us = certain["required"]
    found_us = only_error(tmp_path, text(64, certain_us + 0.1))["data"]["required"]
    tight_us = certain_us + 0.6 * (found_us - certain_us)
    error = only_error(tmp_path, text(64))
    assert (error["code"], error["data"]["proved"]) == ("NS0601", False)
    check_rows(tmp_path, error, text, ())


def test_the_error_for_too_many_words_in_a_slot_divides_them_by_purpose(tmp_path):
    """The parts that NS0603 lists sum to the words of the slot. That number, given as the limit, is
    accepted."""
    (tmp_path / "p.nsl").write_text(STOPS)
    said = invoke(["build", "p.nsl", "-O1", "--max-words-per-slot", "3"], tmp_path)
    assert (said.status, said.codes) == (1, ["NS0603"])
    assert not (tmp_path / "p.icw").exists()
    words = re.search(r"slot \d+ executes (\d+) words", said.err)[1]
    parts = re.search(rf"= {words} words: (.*); launching \d+ kernel", said.err)[1]
    assert sum(int(n) for n in re.findall(r"\d+", parts)) == int(words)
    assert f"--max-words-per-slot {words} accepts the words found" in said.err
    allowed = invoke(["build", "p.nsl", "-O1", "--max-words-per-slot", words], tmp_path)
    assert allowed.status == 0


def test_the_error_for_too_many_words_in_a_slot_names_a_number_of_slots_that_fits(tmp_path):
    bumps = (
        "nsl 1\nframe 100 slots of 1ms\ncode a : 0..99\ncode b : 1..100\nrequire a < b\n"
        "open when a <= n < b\n"
    )
    error = only_error(tmp_path, bumps, "--max-words-per-slot", "10")
    slots = int(re.search(r"frame (\d+) slots", error["rendered"])[1])
    smaller = bumps.replace("100", str(slots)).replace("99", str(slots - 1))
    _, report = built(tmp_path, smaller, "--max-words-per-slot", "10")
    assert within(report, 10)


def test_check_reports_certain_limits_as_errors_and_others_as_notes(tmp_path):
    """One word a slot is too few for any program: error. Three may be enough after a search: note
    NS0503, status 0."""
    (tmp_path / "p.nsl").write_text(STOPS)
    certain = invoke(["check", "p.nsl", "--max-words-per-slot", "1"], tmp_path)
    assert (certain.status, certain.codes) == (1, ["NS0603"])
    assert "certain" in certain.err
    assert "compiled and fits" not in certain.err
    unsure = invoke(["check", "p.nsl", "--max-words-per-slot", "3"], tmp_path)
    assert (unsure.status, unsure.codes) == (0, ["NS0503"])


@pytest.mark.parametrize("command", ["run", "shutters", "view"])
def test_every_command_that_compiles_refuses_programs_above_the_limit_of_words(tmp_path, command):
    """`run`, `shutters` and `view` give NS0603 for a limit of 3 words and write no file."""
    (tmp_path / "p.nsl").write_text(STOPS + "pixels stop = 1 + (x + 4 * y) % 16\n")
    scene = ["--scene", "builtin:dark"] if command == "run" else []
    out = "out.png" if command == "view" else "out.npz"
    limited = [command, "p.nsl", *scene, "-o", out, "-O1", "--max-words-per-slot"]
    refused = invoke([*limited, "3"], tmp_path)
    assert (refused.status, refused.codes) == (1, ["NS0603"])
    assert not (tmp_path / out).exists()


def test_max_words_per_slot_refuses_wrong_values(tmp_path):
    """0, -1 and a word are no limits: NS0783. A compiled program takes no limit any more:
    NS0743."""
    (tmp_path / "p.nsl").write_text(STOPS)
    for value in ("0", "-1", "many"):
        outcome = invoke(["build", "p.nsl", "--max-words-per-slot", value], tmp_path)
        assert (outcome.status, outcome.codes) == (2, ["NS0783"])
    assert invoke(["build", "p.nsl"], tmp_path).status == 0
    late = invoke(["view", "p.icw", "--max-words-per-slot", "9"], tmp_path)
    assert (late.status, late.codes) == (2, ["NS0743"])


@pytest.mark.slow
def test_the_shortest_slot_counts_launches_and_is_printed(tmp_path):
    """The expected slot comes from the container's kernels and launches, from boundary 1 on."""
    (tmp_path / "p.nsl").write_text(book_program(BOOK.tolist()))
    outcome = invoke(["build", "p.nsl", "--emit", "icw,report"], tmp_path)
    container = read_container(tmp_path / "p.icw")
    report = json.loads((tmp_path / "p.report.json").read_text())
    busy, launched = [0.0] * 17, [0] * 17
    for launch in container.launches:
        busy[launch.instant] += kernel_cost(container.kernels[launch.kernel], container.target).us
        launched[launch.instant] += 1
    worst = max(range(1, 16), key=busy.__getitem__)
    shortest_us = busy[worst] + container.target.wait_us
    assert report["shortest_slot_us"] == pytest.approx(shortest_us)
    assert report["launches"] == {
        "frame": len(container.launches),
        "shortest_slot": launched[worst],
        "us_each": container.target.launch_us,
    }
    assert f"shortest legal slot {shortest_us:.4g} us, with {launched[worst]} kernel" in outcome.err
    frame = f"frame 16 slots of {report['shortest_slot_us']:.6f}us"
    assert built(tmp_path, book_program(BOOK.tolist(), frame=frame))[1] is not None
