"""The requests of the playground page, answered with JSON values.

The page asks `nscc play` (HTTP), or Python in a web worker (`page/worker.js`). Both pass the kind
of a request and its values to `Playground.answer`, so the page has one protocol."""

from __future__ import annotations

import json
from base64 import b64decode, b64encode
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from time import perf_counter
from typing import Annotated, Any, Literal
from warnings import catch_warnings

import numpy as np
from numpy.typing import NDArray

from nscc.codec import InvalidRecord, Within, from_plain
from nscc.compiler import CHECK
from nscc.diagnostics.diagnostic import Diagnostic, Label, Rejected
from nscc.diagnostics.rejection import rejected
from nscc.diagnostics.render import render
from nscc.editing.document import Document
from nscc.emit.notebook import shutter_chart
from nscc.emit.summary import summary_rows
from nscc.examples import about, examples, tasks
from nscc.files import write_back
from nscc.pipeline import KINDS
from nscc.shutter_program import ShutterProgram
from nscc.source import Source
from nscc.syntax.parse import VERSIONS, parse
from nscc.syntax.words import reserved, statement_words
from nscc.version import __version__
from nscc.words.shutters import shutters_of
from nscc_runtime.captured import Capture
from nscc_runtime.effects.selection import selected
from nscc_runtime.exposing import capture, scene
from nscc_runtime.pictures.tone import Tone, fitted
from nscc_runtime.reference.watched_pixel import traced
from nscc_runtime.run_messages import frame_lines
from nscc_runtime.scenes.colour import srgb_to_linear

_WHITE_PERCENTILE = 99
"""Percentile of a user's picture whose light is the exposure, as for `nscc run --exposure`."""


@dataclass(frozen=True)
class PageSettings:
    """What the page shows: a program, a scene, and one pixel.

    `picture` is empty, or the grey levels (rows, cols) of the user's picture as bytes in base64,
    with the sRGB curve; the array has this size. Else `scene` names a built-in scene. `exposure_e`
    are electrons over the whole frame, for white."""

    program: str
    scene: str
    picture: str
    exposure_e: Annotated[float, Within(0, 1e9)]
    effects: Literal["none", "auto", "all"]
    seed: Annotated[int, Within(0, 2**31 - 1)]
    row: Annotated[int, Within(0, 2**15)]
    col: Annotated[int, Within(0, 2**15)]


@dataclass
class Playground:
    """The state behind one page: `file` is a program that the page may save, if given. Programs
    may name files in `folder`, but no others."""

    folder: Path
    file: Path | None = None
    _document: Document | None = field(default=None, init=False)
    _taken: tuple[PageSettings, Capture] | None = field(default=None, init=False)
    _took_ms: float = field(default=0.0, init=False)

    def answer(self, kind: str, values: Mapping[str, Any]) -> dict[str, Any]:
        """Return the answer to a request; `messages` are the errors if nscc rejects it.

        The kinds are `start` (examples, words of the language, the file), `check`, `words` (of one
        pixel), `frame` and `merge`, which take `PageSettings`, and `save`, which takes `text` and
        `before`, the text that the file should still have."""
        requests: dict[str, Callable[[PageSettings], dict[str, Any]]] = {
            "check": self._check,
            "words": self._words,
            "frame": self._frame,
            "merge": self._merge,
        }
        try:
            if kind == "start":
                return self._start()
            if kind == "save":
                return self._save(str(values.get("text")), str(values.get("before")))
            if kind not in requests:
                raise _refused(f"unknown request '{kind[:60]}'", f"ask for {', '.join(requests)}")
            try:
                settings = from_plain(PageSettings, values)
            except InvalidRecord as invalid:
                raise _refused(f"invalid request: {invalid}", "reload the page") from invalid
            return requests[kind](settings)
        except Rejected as error:
            return {"messages": _messages(error.diagnostics)}

    def _start(self) -> dict[str, Any]:
        """Return what the page needs at first: examples, keywords by language version, the
        opened file."""
        paths = examples()
        programs = [
            {
                "name": name,
                "task": task,
                "about": about(paths[name]),
                "scene": shown.scene,
                "exposure_e": shown.exposure,
                "text": paths[name].read_text(encoding="utf-8"),
            }
            for task, named in tasks().items()
            for name, shown in named.items()
        ]
        words = {
            version: [
                sorted(statement_words(version)),
                sorted(word for word in reserved(version) if word.isalpha()),
            ]
            for version in VERSIONS
        }
        opened = None
        if self.file is not None:
            opened = {"name": self.file.name, "text": self.file.read_text(encoding="utf-8")}
        return {"version": __version__, "examples": programs, "words": words, "file": opened}

    def _save(self, text: str, before: str) -> dict[str, Any]:
        """Write the program to the opened file; `before` is the text that the page read from it.

        Raises Rejected if no file was opened, or if another program has changed it since."""
        if self.file is None:
            raise _refused("no file was opened", "start `nscc play FILE`, or download the program")
        if self.file.read_text(encoding="utf-8") != before:
            raise _refused(
                f"'{self.file.name}' was changed by another program since it was opened",
                "download the program, then reload the page to see the other text",
            )
        write_back(self.file, text.encode())
        return {"saved": self.file.name}

    def _check(self, settings: PageSettings) -> dict[str, Any]:
        """Return the messages of a program and, if it compiles, its summary, shutters and their
        map."""
        document = self._opened(settings.program)
        diagnostics, compiled = document.checked.diagnostics, document.checked.compiled
        answer: dict[str, Any] = {"messages": _messages(diagnostics)}
        if compiled is None:
            return answer
        target, container = compiled.program.target, compiled.container
        answer |= {"rows": summary_rows(compiled), "chart": "", "array": [target.rows, target.cols]}
        if container is not None and KINDS.of(container).shutters_known and container.has_table:
            drawn, table = shutters_of(container), container.table
            answer["chart"] = shutter_chart(
                drawn.rows, drawn.labels, container.slot_us, container.buckets
            )
            if container.pixel_codes is not None:
                rank = drawn.rank[table.shutter_of_code[container.pixel_codes]]
                answer["map"] = _encoded(rank.astype("<u2"))
        return answer

    def _words(self, settings: PageSettings) -> dict[str, Any]:
        """Return every word that runs in one pixel with the registers after it.

        Raises Rejected for a pixel outside the array."""
        taken = self._captured(settings)
        rows, cols = taken.container.target.rows, taken.container.target.cols
        if settings.row >= rows or settings.col >= cols:
            raise _refused(f"the array has {rows} x {cols} pixels", "choose a pixel inside it")
        effects = "all" if settings.effects == "auto" else settings.effects
        origin = taken.exposed.simulated.origin
        pixel = settings.row, settings.col
        return traced(
            taken.container, taken.light, origin.sensor, selected(effects), pixel, settings.seed
        )

    def _frame(self, settings: PageSettings) -> dict[str, Any]:
        """Return pictures of light, readouts, images and planes of a captured frame, with its
        figures."""
        taken = self._captured(settings)
        light = _open_light_e(taken)
        pictures = [_picture("the light", _tone(light)(light))]
        pictures += [
            _picture(f"read out: {name}", codes)
            for name, codes in zip(taken.container.buckets_read, taken.frame, strict=True)
        ]
        pictures += [
            _picture(f"image {name}", _stretched(values)) for name, values in taken.images.items()
        ]
        pictures += [_picture(f"plane {name}", bits * 255) for name, bits in taken.planes.items()]
        plan = "" if taken.plan is None else str(taken.plan)
        lines = frame_lines(taken.container, taken)
        merges = len(taken.frame) > 0
        return {
            "pictures": pictures,
            "lines": lines,
            "plan": plan,
            "merges": merges,
            "ms": round(self._took_ms),
        }

    def _merge(self, settings: PageSettings) -> dict[str, Any]:
        """Return the pictures of the light that merging estimates."""
        taken = self._captured(settings)
        truth = _open_light_e(taken)
        frame_s = float(taken.container.slot_s.sum())
        pictures = [
            _picture(f"merged: {name}", _tone(truth)(light * frame_s))
            for name, light in zip(taken.container.buckets_read, taken.light_e_per_s(), strict=True)
        ]
        return {"pictures": pictures}

    def _opened(self, text: str) -> Document:
        """Return the document of a program text, the same object for the same text; raise
        Rejected if it names files elsewhere."""
        if self._document is None or self._document.text != text:
            name = "program.nsl" if self.file is None else self.file.name
            self._document = Document(name, text, self.folder)
            self._refuse_files_elsewhere(self._document.source)
        return self._document

    def _refuse_files_elsewhere(self, source: Source) -> None:
        """Raise Rejected if the program names a file outside of its folder."""
        folder = self.folder.resolve()
        for statement in parse(source)[0].statements:
            path = getattr(statement, "path", None)
            if path is not None and not (folder / path.value).resolve().is_relative_to(folder):
                self._document = None
                raise _refused(
                    f"the program names the file '{path.value[:60]}' outside of its folder",
                    "copy the file into the folder of the program",
                    source=source,
                    label=Label(path.span),
                )

    def _captured(self, settings: PageSettings) -> Capture:
        """Return the frame of a program, from the last request if its settings were equal."""
        settings = replace(settings, row=0, col=0)
        if self._taken is None or self._taken[0] != settings:
            program, begin = self._compiled(settings.program), perf_counter()
            self._taken = settings, _captured(program, settings)
            self._took_ms = 1e3 * (perf_counter() - begin)
        return self._taken[1]

    def _compiled(self, text: str) -> ShutterProgram:
        """Return the compiled program; raise Rejected with its diagnostics if it does not
        compile."""
        document = self._opened(text)
        diagnostics, compiled = document.checked.diagnostics, document.checked.compiled
        if compiled is None or compiled.container is None:
            raise Rejected(diagnostics)
        return ShutterProgram(document.name, compiled.container, compiled, CHECK)


def _captured(program: ShutterProgram, settings: PageSettings) -> Capture:
    """Expose a program to the scene of the settings: the page's picture, a built-in scene, or none.

    Raises Rejected if the picture does not fit the array."""
    rows, cols = program.shape
    if settings.picture:
        levels = np.frombuffer(_decoded(settings.picture), np.uint8)
        if levels.size != rows * cols:
            raise _refused(
                f"the picture has {levels.size} pixels, the array {rows} x {cols}",
                "check the program before the picture, so that the page knows the array",
            )
        linear = srgb_to_linear(levels.reshape(rows, cols) / 255.0)
        white = float(np.percentile(linear, _WHITE_PERCENTILE)) * sum(program.slot_us) * 1e-6
        light: Any = (linear * (settings.exposure_e / white if white else 0.0)).astype(np.float32)
    elif settings.scene.startswith("builtin:"):
        light = scene(settings.scene, exposure=settings.exposure_e)
    else:
        raise _refused(
            f"'{settings.scene[:60]}' is not a built-in scene", "open a picture in the page instead"
        )
    with catch_warnings(record=True):  # the page shows the marks of the frame instead
        return capture(program, light, effects=settings.effects, seed=settings.seed)


def _open_light_e(taken: Capture) -> NDArray[np.floating[Any]]:
    """Return the electrons (rows, cols) that open pixels would collect in the frame."""
    truth_e = taken.truth_e
    return truth_e if truth_e.ndim == 2 else truth_e.sum(axis=0, dtype=np.float64)


def _tone(light_e: NDArray[np.floating[Any]]) -> Tone:
    """Return the tone curve of the playground's pictures."""
    return fitted("log", light_e)


def _stretched(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return an image with its smallest value black and its largest value white."""
    levels: NDArray[np.float64] = 255.0 * (values - values.min()) / (np.ptp(values) or 1.0)
    return levels


def _picture(title: str, levels: NDArray[Any]) -> dict[str, Any]:
    """Return a grey picture (rows, cols) of 0..255."""
    rows, cols = levels.shape
    return {"title": title, "rows": rows, "cols": cols, "grey": _encoded(levels.astype(np.uint8))}


def _encoded(values: NDArray[Any]) -> str:
    """Return the bytes of an array in base64."""
    return b64encode(values.tobytes()).decode()


def _decoded(text: str) -> bytes:
    """Return the bytes of base64 text; raise Rejected for other text."""
    try:
        return b64decode(text, validate=True)
    except ValueError as invalid:
        raise _refused("the picture is not base64", "reload the page") from invalid


def _messages(diagnostics: Iterable[Diagnostic]) -> list[Any]:
    """Return diagnostics as JSON values, as `--message-format json` prints them."""
    return [json.loads(line) for line in render([*diagnostics], "json").splitlines()]


def _refused(message: str, help_text: str, **about: Any) -> Rejected:
    """Return the error (NS0796) for an invalid request."""
    return rejected("NS0796", message, helps=(help_text,), **about)
