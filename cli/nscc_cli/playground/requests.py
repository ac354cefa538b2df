"""The requests of the playground page, answered with JSON values.

The page asks `nscc play` (HTTP), or Python in a web worker (`page/worker.js`). Both pass the kind
of a request and its values to `Playground.answer`, so the page has one protocol."""

from __future__ import annotations

import json
from base64 import b64decode, b64encode
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Any, Literal
from warnings import catch_warnings

import numpy as np

from nscc.arrays import Array, Floats32
from nscc.codec import InvalidRecord, from_plain
from nscc.compiler import CHECK
from nscc.diagnostics.diagnostic import Diagnostic, Label, Rejected, rejected
from nscc.diagnostics.render import render
from nscc.editing.document import Document
from nscc.emit.notebook import container_chart
from nscc.emit.summary import summary_rows
from nscc.examples import about, examples, tasks
from nscc.files import write_back
from nscc.mappings import JsonObject
from nscc.shutter_program import ShutterProgram
from nscc.syntax.parse import VERSIONS
from nscc.syntax.words import reserved, statement_words
from nscc.version import __version__
from nscc.words.shutters import shutters_of
from nscc_runtime.captured import Capture
from nscc_runtime.effects.selection import selected
from nscc_runtime.exposing import capture, scene
from nscc_runtime.pictures.tone import fitted
from nscc_runtime.reference.watched_pixel import traced
from nscc_runtime.run_messages import frame_lines


@dataclass(frozen=True)
class PageSettings:
    """What the page shows: a `program` (its text), a scene, its exposure, and one pixel (`row`,
    `col`).

    `picture` is empty, or the light of the user's picture relative to white, float32 (rows, cols)
    of the array in base64. Else `scene` names a built-in scene. `exposure_e` are the electrons of
    white over the whole frame. `effects` are the simulated effects, and `seed` determines their
    random numbers."""

    program: str
    scene: Literal["", "builtin:hdr", "builtin:motion"]
    picture: str
    exposure_e: float
    effects: Literal["none", "auto", "all"]
    seed: int
    row: int
    col: int


class Playground:
    """Answers the requests of one page. `file` is the program that the page may save, None if there
    is none.

    Programs may name files in `folder`, but no others. The last program and the last frame are
    kept, so that requests about them are fast."""

    def __init__(self, folder: Path, file: Path | None = None) -> None:
        """Begin without a program and a frame, for programs that may name files in `folder`; each
        is computed at the first request that needs it."""
        self.folder, self.file = folder, file
        self._document = lru_cache(1)(self._opened)
        self._capture = lru_cache(1)(self._exposed)

    def answer(self, kind: str, values: Mapping[str, Any]) -> JsonObject:
        """Return the answer to a request as JSON values. If nscc rejects the request or its values
        are invalid, the answer has only `messages`, the errors.

        The kinds are `start` (examples, words of the language, the file), `check`, `frame` and
        `words` (of one pixel), which take `PageSettings`, and `save`, which takes `text` and
        `before`, the text that the file should still have."""
        requests = {"check": self._check, "frame": self._frame, "words": self._words}
        try:
            if kind == "start":
                return self._start()
            if kind == "save":
                return self._save(str(values.get("text")), str(values.get("before")))
            if kind not in requests:
                raise InvalidRecord(f"is none of start, save, {', '.join(requests)}", kind[:60])
            return requests[kind](from_plain(PageSettings, values))
        except InvalidRecord as invalid:
            refusal = _refused(f"invalid request: {invalid}", "reload the page")
        except Rejected as rejection:
            refusal = rejection
        return {"messages": _messages(refusal.diagnostics)}

    def _start(self) -> JsonObject:
        """Return what the page needs at first, as JSON values: `version`, `examples`, `words` and
        the opened `file` (None without one). `words` has for each version of the language the
        keywords that begin statements and the reserved words."""
        paths = examples()
        programs = [
            vars(shown)
            | {"name": name, "task": task, "about": about(paths[name]), "text": _text(paths[name])}
            for task, named in tasks().items()
            for name, shown in named.items()
        ]
        words = {v: [sorted(statement_words(v)), sorted(reserved(v))] for v in VERSIONS}
        opened = self.file and {"name": self.file.name, "text": _text(self.file)}
        return {"version": __version__, "examples": programs, "words": words, "file": opened}

    def _save(self, text: str, before: str) -> JsonObject:
        """Write `text` to the opened file and return its name (`saved`). `before` is the text that
        the page read from it.

        Raises Rejected (NS0796) if no file was opened, or if another program has changed it since.
        """
        if self.file is None:
            raise _refused("no file was opened", "start `nscc play FILE`, or download the program")
        if _text(self.file) != before:
            raise _refused(
                f"'{self.file.name}' was changed by another program since it was opened",
                "download the program, then reload the page to see the other text",
            )
        write_back(self.file, text.encode())
        return {"saved": self.file.name}

    def _check(self, settings: PageSettings) -> JsonObject:
        """Return the messages of the program in `settings` as JSON values.

        Of a valid one also its report (`rows`), the size of the array, the chart of its shutters,
        and `map`: the rank of each pixel's shutter, uint16 in base64."""
        checked = self._document(settings.program).checked
        answer: JsonObject = {"messages": _messages(checked.diagnostics)}
        if checked.compiled is None:
            return answer
        target, container = checked.compiled.program.target, checked.compiled.container
        answer |= {"rows": summary_rows(checked.compiled), "array": [target.rows, target.cols]}
        if container is not None:
            answer["chart"] = container_chart(container)
            if answer["chart"] and container.pixel_codes is not None:
                shutter_of_pixel = container.table.shutter_of_code[container.pixel_codes]
                ranks = shutters_of(container).rank[shutter_of_pixel]
                answer["map"] = _encoded(ranks.astype("<u2"))
        return answer

    def _words(self, settings: PageSettings) -> JsonObject:
        """Return the words of a frame exposed with `settings` and the registers of its chosen
        pixel, as JSON values. The scene is exposed first if the last frame had other settings.
        Raises Rejected for a pixel outside the array."""
        # The frame does not depend on the pixel: it is kept for requests about others.
        taken = self._capture(replace(settings, row=0, col=0))
        rows, cols = taken.container.target.rows, taken.container.target.cols
        if not (0 <= settings.row < rows and 0 <= settings.col < cols):
            raise _refused(f"the array has {rows} x {cols} pixels", "choose a pixel inside it")
        effects = selected("all" if settings.effects == "auto" else settings.effects)
        sensor = taken.exposed.simulated.origin.sensor
        pixel = settings.row, settings.col
        return traced(taken.container, taken.light, sensor, effects, pixel, settings.seed)

    def _frame(self, settings: PageSettings) -> JsonObject:
        """Return a frame exposed with `settings` as JSON values: its `pictures` (8 bits in base64),
        the lines of its description, and its plan.

        The pictures are the light, the readout of each bucket, images and planes, and the merged
        light."""
        taken = self._capture(replace(settings, row=0, col=0))
        buckets = taken.container.buckets_read
        # The electrons that pixels which are always open would collect.
        truth_e = taken.truth_e
        light_e = truth_e.reshape(-1, *truth_e.shape[-2:]).sum(axis=0, dtype=np.float64)
        tone = fitted("log", light_e)
        shown: dict[str, Array] = {"the light": tone(light_e)}
        shown |= {f"read out: {name}": taken.frame[k] for k, name in enumerate(buckets)}
        # From black to white; `or 1.0` is for an image with the same value everywhere.
        for name, values in taken.images.items():
            shown[f"image {name}"] = 255 * (values - values.min()) / (np.ptp(values) or 1.0)
        shown |= {f"plane {name}": bits * 255 for name, bits in taken.planes.items()}
        with suppress(Rejected):  # of programs without buckets to merge
            merged_e = taken.light_e_per_s() * float(taken.container.slot_s.sum())
            shown |= {f"merged: {name}": tone(merged_e[k]) for k, name in enumerate(buckets)}
        pictures = [
            {"title": title, "shape": grey.shape, "grey": _encoded(grey.astype(np.uint8))}
            for title, grey in shown.items()
        ]
        plan = "" if taken.plan is None else str(taken.plan)
        return {"pictures": pictures, "lines": frame_lines(taken.container, taken), "plan": plan}

    def _opened(self, text: str) -> Document:
        """Return the document of the program `text`; raise Rejected (NS0796) if it names files
        outside of its folder."""
        document = Document(self.file.name if self.file else "program.nsl", text, self.folder)
        folder = self.folder.resolve()
        for statement in document.parsed[0].statements:
            path = getattr(statement, "path", None)
            if path is not None and not (folder / path.value).resolve().is_relative_to(folder):
                raise _refused(
                    f"the program names the file '{path.value[:60]}' outside of its folder",
                    "copy the file into the folder of the program",
                    source=document.source,
                    label=Label(path.span),
                )
        return document

    def _exposed(self, settings: PageSettings) -> Capture:
        """Expose the scene of `settings` with their program. Raise Rejected with the compiler's
        errors if it is invalid. Warnings are dropped."""
        document = self._document(settings.program)
        compiled = document.checked.compiled
        if compiled is None or compiled.container is None:
            raise Rejected(document.checked.diagnostics)
        program = ShutterProgram(document.name, compiled.container, compiled, CHECK)
        light: Any = scene(settings.scene, exposure=settings.exposure_e)
        if settings.picture:
            white_e_per_s = settings.exposure_e / (sum(program.slot_us) * 1e-6)
            light = _picture(settings.picture, program.shape) * np.float32(white_e_per_s)
        with catch_warnings(record=True):  # the page shows the marks of the frame instead
            return capture(program, light, effects=settings.effects, seed=settings.seed)


def _picture(text: str, shape: tuple[int, int]) -> Floats32:
    """Return the light of a user's picture, which `text` has as little-endian float32 in base64,
    row by row, as an array of `shape` (rows, cols). Raise Rejected (NS0796) for another length and
    for text that is not base64."""
    try:
        return np.frombuffer(b64decode(text, validate=True), "<f4").reshape(shape)
    except ValueError as invalid:
        raise _refused(
            f"the picture is not {shape[0]} x {shape[1]} numbers in base64",
            "check the program before the picture, so that the page knows the array",
        ) from invalid


def _text(path: Path) -> str:
    """Return the text of a file."""
    return path.read_text(encoding="utf-8")


def _encoded(values: Array) -> str:
    """Return the bytes of an array in base64, row by row and in its own type."""
    return b64encode(values.tobytes()).decode()


def _messages(diagnostics: Iterable[Diagnostic]) -> list[Any]:
    """Return diagnostics as JSON values, as `--message-format json` prints them."""
    return [json.loads(line) for line in render([*diagnostics], "json").splitlines()]


def _refused(message: str, help_text: str, **about: Any) -> Rejected:
    """Return the error (NS0796) for an invalid request, for the caller to raise. `about` are
    further fields of `Diagnostic`."""
    return rejected("NS0796", message, helps=(help_text,), **about)
