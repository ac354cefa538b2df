"""The declarations of a file, by name, with reports of duplicate and missing statements."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import assert_never

from nscc.diagnostics.diagnostic import Label
from nscc.mappings import NamedValues
from nscc.program.limits import MOST_FIELDS
from nscc.program.problems import Problems
from nscc.source import Span
from nscc.syntax import tree

PREDEFINED = {
    "N": "the number of slots",
    "n": "the slot, 0 .. N-1",
    "x": "the column of a pixel",
    "y": "the row of a pixel",
    "rows": "the number of rows of the array",
    "cols": "the number of columns of the array",
}

_OF_PIXELS = ("x", "y")
"""Predefined names that images and planes may have: only `pixels FIELD = ..` reads them."""

LOOKS = "looks"
"""In version 2, the name of the number of boundaries with at least one sense, up to the current
one."""

State = tree.StateRange | tree.StateBit
"""A declaration of a state, by its range or as single bits."""
Code = tree.CodeRange | tree.CodeBits | tree.CodeRow
"""A declaration of a code, by its range, as single bits, or as a row of a codebook."""
Book = tree.BookInline | tree.BookFromFile
"""A declaration of a codebook, written in the program or read from a file."""
Rule = tree.Open | tree.Bucket
"""A statement that opens the shutter, with or without a bucket."""


class Declarations:
    """The statements of a file by kind and name, each name once, in the order of the text.

    `pixels` contains the first `pixels FIELD = ...` for each name, whether or not that is a field;
    `pixels_file` is the statement `pixels from`. `wide` are the bit fields that do not fit a
    number, once their lengths are known. `refused` are names with an invalid or a second
    declaration; their meaning is unknown, and using them is not reported again. `repeats` maps the
    names that `repeat` changes to their statement; `pictures` contains these names with their
    steps."""

    def __init__(self, statements: tuple[tree.Statement, ...]) -> None:
        """Begin without declarations; `gather` fills them from the statements."""
        self.statements = statements
        self.target: tree.TargetByName | tree.TargetFromFile | None = None
        self.frame: tree.EqualSlots | tree.ListedSlots | None = None
        self.lets: dict[str, tree.Let] = {}
        self.codes: dict[str, Code] = {}
        self.books: dict[str, Book] = {}
        self.requires: list[tree.Require] = []
        self.rules: list[Rule] = []
        self.pixels: dict[str, tree.PixelsExpr | tree.PixelsTile] = {}
        self.pixels_file: tree.PixelsFromFile | None = None
        self.refused: set[str] = set()
        self.wide: set[str] = set()
        self.version = 1
        self.senses: dict[str, tree.Sense] = {}
        self.states: dict[str, State] = {}
        self.nexts: dict[str, tree.Next] = {}
        self.reset: tree.Reset | None = None
        self.reads: dict[str, tree.Name] = {}
        self.kernels: dict[str, tree.Kernel | tree.KernelFromFile] = {}
        self.pictures: list[tree.Image | tree.Plane] = []
        self.outside: tree.Outside | None = None
        self.assumes: list[tree.Assume] = []
        self.reports: list[tree.Report] = []
        self.params: dict[str, tree.Param] = {}
        self.inputs: dict[str, tree.Input] = {}
        self.input_starts: dict[str, tree.PixelsExpr | tree.PixelsTile] = {}
        self.kept_images: dict[str, tree.StateImage] = {}
        self.repeats: dict[str, tree.Repeat] = {}

    @property
    def looking(self) -> bool:
        """Whether pixels look at their light: whether the file has senses, states, a reset or
        readouts of states. States that change with images and planes do not count."""
        if self.keeps_planes:
            return False
        reads = () if self.has_pictures else self.reads
        return bool(self.senses or self.states or self.nexts or reads or self.reset)

    @property
    def keeps_planes(self) -> bool:
        """Whether states change with images and planes after the last slot, instead of at looks. A
        file with senses or a reset has looks."""
        states = self.states or self.kept_images
        return bool(states and self.has_pictures and not (self.senses or self.reset))

    @property
    def has_pictures(self) -> bool:
        """Whether the file has images, planes, convolution kernels, reports or values that the host
        sets.

        A `next` without any sense also counts: its state changes with images and planes. So does a
        `read` without states, which names exposures."""
        steps = self.nexts and self.version > 2 and not self.senses
        host = self.params or self.inputs or self.kept_images
        reads = self.reads and self.version > 2 and not (self.states or self.senses)
        words = self.pictures or self.reports or self.kernels or self.assumes
        return bool(words or steps or host or reads)

    @property
    def has_pixels(self) -> bool:
        """Whether the file gives codes of pixels, in `pixels` statements or by a file."""
        return bool(self.pixels) or self.pixels_file is not None

    def declared(self) -> Iterator[tuple[str, str]]:
        """Yield every declared name that expressions may use, with its kind in words, such as "a
        field". Predefined names and buckets are not among them."""
        kinds: dict[str, Iterable[str]] = {
            "a let": self.lets,
            "a field": self.codes,
            "a codebook": self.books,
            "a sense": self.senses,
            "a state": self.states,
            "a kernel": self.kernels,
            "a parameter": self.params,
            "an input plane": self.inputs,
            "a kept image": self.kept_images,
        }
        for kind, names in kinds.items():
            for name in names:
                yield name, kind
        for picture in self.pictures:
            yield picture.name.text, "an image" if isinstance(picture, tree.Image) else "a plane"

    def report_other(
        self,
        name: tree.Name,
        kind: str,
        note: str,
        known: Iterable[str],
        helps: tuple[str, ...],
        problems: Problems,
    ) -> None:
        """Report that a name is not of the required `kind` (NS0209, or NS0214 for an unknown name).

        `kind` is in words with an article, such as "a field". `known` are the names of this kind,
        of which the most similar is suggested. `note` ends the message of NS0209. `helps` belong to
        NS0209. Names whose declaration has an error are not reported."""
        text = name.text
        if text in self.refused:
            return
        declared_as = dict(self.declared()).get(text)
        if declared_as is None:
            problems.unknown(kind, text, name.span, known)
        else:
            message = f"`{text}` is {declared_as}, not {kind}{note}"
            problems.error("NS0209", message, name.span, declared_as, helps=helps)


def gather(file: tree.File, problems: Problems) -> Declarations:
    """Return the declarations of `file`, without those that are reported; of two with one name, the
    first counts.

    Reports names declared twice (NS0201) or predefined (NS0202), a missing frame or rule (NS0204),
    a statement that occurs twice (NS0205), `open` beside buckets (NS0206), a field whose pixels are
    given twice (NS0211) and too many fields (NS0450)."""
    gatherer = _Gatherer(Declarations(file.statements), problems)
    for statement in file.statements:
        gatherer.add(statement)
    gatherer.finish(file)
    return gatherer.declared


class _Gatherer:
    """Adds the statements of a file to its declarations, and reports names and statements that
    occur twice."""

    def __init__(self, declared: Declarations, problems: Problems) -> None:
        """Begin to fill `declared`, which is empty; errors are added to `problems`."""
        self.declared, self.problems = declared, problems
        self.first_place: dict[str, Span] = {}
        self.mixed = False

    def add(self, statement: tree.Statement) -> None:
        """Add one statement to the declarations of its kind, or report why it is not allowed
        (NS0201, NS0202, NS0205, NS0206, NS0211)."""
        declared = self.declared
        match statement:
            case tree.Version():
                declared.version = statement.number.value
            case tree.TargetByName() | tree.TargetFromFile():
                if self._is_first("target", declared.target, statement):
                    declared.target = statement
            case tree.EqualSlots() | tree.ListedSlots():
                if self._is_first("frame", declared.frame, statement):
                    declared.frame = statement
            case tree.Let():
                self._name(declared.lets, statement.name, statement)
            case tree.CodeRange() | tree.CodeBits() | tree.CodeRow():
                self._name(declared.codes, statement.name, statement)
            case tree.BookInline() | tree.BookFromFile():
                self._name(declared.books, statement.name, statement)
            case tree.Require():
                declared.requires.append(statement)
            case tree.Open() | tree.Bucket():
                self._rule(statement)
            case tree.Sense():
                self._name(declared.senses, statement.name, statement)
            case tree.StateRange() | tree.StateBit():
                self._name(declared.states, statement.name, statement)
            case tree.Next():
                name = statement.name.text
                if self._is_first(f"next {name}", declared.nexts.get(name), statement):
                    declared.nexts[name] = statement
            case tree.Reset():
                if self._is_first("reset when", declared.reset, statement):
                    declared.reset = statement
            case tree.Read():
                for read_name in statement.names:
                    declared.reads.setdefault(read_name.text, read_name)
            case tree.Kernel() | tree.KernelFromFile():
                self._name(declared.kernels, statement.name, statement)
            case tree.Image() | tree.Plane():
                if self._is_new_name(statement.name, *_OF_PIXELS):
                    declared.pictures.append(statement)
            case tree.Repeat():
                for item in statement.items:
                    make = tree.Image if item.kind == "image" else tree.Plane
                    if self._is_new_name(item.name, *_OF_PIXELS):
                        declared.pictures.append(make(item.span, item.name, item.step))
                        declared.repeats[item.name.text] = statement
            case tree.Param():
                self._name(declared.params, statement.name, statement)
            case tree.Input():
                self._name(declared.inputs, statement.name, statement)
            case tree.StateImage():
                self._name(declared.kept_images, statement.name, statement)
            case tree.Outside():
                if self._is_first("outside", declared.outside, statement):
                    declared.outside = statement
            case tree.Assume():
                declared.assumes.append(statement)
            case tree.Report():
                declared.reports.append(statement)
            case tree.PixelsExpr() | tree.PixelsTile():
                field = statement.field
                first = declared.pixels.setdefault(field.text, statement)
                if first is not statement:
                    message = f"the pixel values of `{field.text}` are given twice"
                    related = (Label(first.field.span, "the first"),)
                    self.problems.error(
                        "NS0211", message, field.span, "the second", related=related
                    )
            case tree.PixelsFromFile():
                if self._is_first("pixels from", declared.pixels_file, statement):
                    declared.pixels_file = statement
            case _:
                assert_never(statement)

    def finish(self, file: tree.File) -> None:
        """Report missing statements (NS0204) and too many fields (NS0450); move `pixels` of input
        planes from the pixel values to `input_starts`."""
        for name in self.declared.inputs.keys() & self.declared.pixels.keys():
            self.declared.input_starts[name] = self.declared.pixels.pop(name)
        span = file.statements[0].span if file.statements else Span(0, 0)
        if self.declared.frame is None:
            message = "the program has no `frame` statement"
            helps = ("add the number and the length of the slots: `frame 256 slots of 125us`",)
            self.problems.error("NS0204", message, span, "`frame` is missing", helps=helps)
        if not self.declared.rules:
            message = "the program has no `open when` and no `bucket`"
            helps = ("add a rule that says when a shutter is open: `open when n < stop`",)
            self.problems.error(
                "NS0204", message, span, "`open when` or `bucket` is missing", helps=helps
            )
        fields = list(self.declared.codes.values())
        if len(fields) > MOST_FIELDS:
            span, text = fields[MOST_FIELDS].name.span, f"field number {MOST_FIELDS + 1}"
            message = (
                f"the pixel code has {len(fields)} fields, but at most {MOST_FIELDS} are allowed"
            )
            helps = ("combine single bits in one field: `code bits : bit[K]`",)
            self.problems.error("NS0450", message, span, text, helps=helps)

    def _is_first(self, word: str, first: tree.Statement | None, second: tree.Statement) -> bool:
        """Return whether a statement is the first of its kind; else report `second` (NS0205).

        `word` is the statement's keyword in the message, and `first` is the statement stored
        before, or None."""
        if first is None:
            return True
        message = f"`{word}` is given twice, but a program has only one"
        related = (Label(first.span, "the first"),)
        self.problems.error("NS0205", message, second.span, "the second", related=related)
        return False

    def _name(self, named: NamedValues, name: tree.Name, statement: tree.Statement) -> None:
        """Store a statement in `named` under the name that it declares, unless the name is taken or
        predefined; that is reported."""
        if self._is_new_name(name):
            named[name.text] = statement

    def _is_new_name(self, name: tree.Name, *allowed: str) -> bool:
        """Return whether a name is neither declared nor predefined; else report it (NS0201,
        NS0202).

        Predefined names in `allowed` may be declared. A reported name is added to `refused`."""
        meaning = None if name.text in allowed else PREDEFINED.get(name.text)
        if name.text == LOOKS and self.declared.version > 1:
            meaning = "the number of looks so far"
        if meaning is not None:
            self.declared.refused.add(name.text)
            message = f"`{name.text}` is predefined and cannot be declared"
            text = f"`{name.text}` is {meaning}"
            self.problems.error("NS0202", message, name.span, text, helps=("choose another name",))
            return False
        if self._is_unused(name, f"`{name.text}` is declared twice", name.text):
            return True
        self.declared.refused.add(name.text)
        return False

    def _is_unused(self, name: tree.Name, message: str, key: str) -> bool:
        """Return whether `key`, the name or its kind and name, was not declared before; else report
        `message` (NS0201) at `name`."""
        first = self.first_place.setdefault(key, name.span)
        # `setdefault` returned this very span, so the key is new.
        if first is name.span:
            return True
        self.problems.error(
            "NS0201",
            message,
            name.span,
            "the second",
            related=(Label(first, "the first"),),
            helps=("choose another name for one of them",),
        )
        return False

    def _rule(self, rule: Rule) -> None:
        """Add an `open` or `bucket` rule, or report why it is not allowed (NS0201, NS0205, NS0206).

        A program has one `open` or several buckets, not both."""
        rules = self.declared.rules
        if rules and isinstance(rules[0], tree.Open) != isinstance(rule, tree.Open):
            if self.mixed:  # reported once for a program
                return
            self.mixed = True
            self.problems.error(
                "NS0206",
                "a program must have either one `open when` or named buckets",
                rule.span,
                "this rule has the other form",
                related=(Label(rules[0].span, "the first rule"),),
                helps=("give each exposure of the frame a name: `bucket NAME open when ...`",),
            )
        elif isinstance(rule, tree.Open):
            if self._is_first("open when", rules[0] if rules else None, rule):
                rules.append(rule)
        elif self.declared.version > 2 and not self._is_unused(
            rule.name, f"`{rule.name.text}` is declared twice", rule.name.text
        ):
            return
        # Buckets have separate names (the key cannot be a name): before version 3, no expression
        # reads them.
        elif self._is_unused(
            rule.name, f"two buckets have the name `{rule.name.text}`", f"bucket {rule.name.text}"
        ):
            rules.append(rule)
