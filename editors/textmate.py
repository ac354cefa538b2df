"""The TextMate grammar of shutter programs, made from grammars/nsl.lark.

    python editors/textmate.py           # writes editors/vscode/syntaxes/nsl.tmLanguage.json
    python editors/textmate.py --check   # writes nothing; 1 if the file is another

Words and the forms of numbers, texts and names are the terminals of the grammar; only what each is
called for colours stands here. `nsl 2` opens the rest of a file to the words of version 2, which
are names before it.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

from nscc.editing.mentions import DECLARES
from nscc.program.names import LOOKS, PREDEFINED
from nscc.syntax.words import parser, reserved, statement_words

OUT = Path(__file__).parent / "vscode" / "syntaxes" / "nsl.tmLanguage.json"

_WORDS_OF_EXPRESSIONS = ("and", "else", "if", "in", "not", "or", "xor")
_FUNCTIONS = ("max", "min")
_TRUTH = ("false", "true")


def grammar() -> dict[str, Any]:
    """The grammar as JSON values."""
    versions = {
        f"version-{number}": {
            "name": f"meta.program.version-{number}.nsl",
            "begin": rf"\b(nsl)\s+({number})\b",
            "beginCaptures": {
                "1": {"name": "keyword.control.nsl"},
                "2": {"name": "constant.numeric.nsl"},
            },
            "end": "(?!)",  # the end of the file
            "patterns": _patterns(number),
        }
        for number in (4, 3, 2, 1)
    }
    return {
        "name": "Shutter program",
        "scopeName": "source.nsl",
        "fileTypes": ["nsl"],
        "patterns": [*({"include": f"#{name}"} for name in versions), *_patterns(1)],
        "repository": versions,
    }


def _patterns(version: int) -> list[dict[str, Any]]:
    """What is coloured in a version, the first that matches before the others."""
    name = _terminal("NAME")
    declaring = _any(word for word in (*DECLARES, "bucket") if word in statement_words(version))
    words = {word for word in reserved(version) if word.isalpha()}
    statements = [word for word in statement_words(version) if word in words]
    apart = {*statements, *_WORDS_OF_EXPRESSIONS, *_FUNCTIONS, *_TRUTH}
    predefined = [*PREDEFINED, *([LOOKS] if version > 1 else [])]
    return [
        {"name": "comment.line.number-sign.nsl", "match": r"#[^\r\n]*"},
        {"name": "string.quoted.double.nsl", "match": _terminal("TEXT")},
        {"name": "invalid.illegal.unclosed.nsl", "match": _terminal("UNCLOSED")},
        _pair(r"(target)\s+(" + _terminal("TARGET_NAME") + ")", "entity.name.type.nsl"),
        _pair(rf"({declaring})\s+(?!{_any(words)}\b)({name})", "variable.other.declaration.nsl"),
        _words("keyword.control.nsl", statements),
        _words("keyword.operator.word.nsl", words & {*_WORDS_OF_EXPRESSIONS}),
        _words("support.function.nsl", words & {*_FUNCTIONS}),
        _words("constant.language.nsl", words & {*_TRUTH}),
        _words("keyword.other.nsl", words - apart),
        _words("variable.language.nsl", predefined),
        {"name": "constant.numeric.time.nsl", "match": _terminal("TIME")},
        *(
            [{"name": "constant.numeric.level.nsl", "match": _terminal("LEVEL")}]
            if version > 1
            else []
        ),
        {"name": "constant.numeric.digits.nsl", "match": _terminal("GROUPED")},
        {"name": "constant.numeric.nsl", "match": _terminal("INTEGER")},
        {"name": "invalid.illegal.number.nsl", "match": _terminal("MALFORMED")},
        *(
            [{"name": "entity.name.function.nsl", "match": _terminal("FUNCTION")}]
            if version > 2
            else []
        ),
        {"name": "variable.other.nsl", "match": name},
        {"name": "keyword.operator.nsl", "match": r"\.\.|<<|[-+*/%=:]=?|" + _comparison()},
        {"name": "punctuation.nsl", "match": r"[\[\](),]"},
    ]


def _pair(match: str, second: str) -> dict[str, Any]:
    """A statement's word and the name behind it."""
    captures = {"1": {"name": "keyword.control.nsl"}, "2": {"name": second}}
    return {"match": rf"\b{match}", "captures": captures}


def _words(scope: str, words: Any) -> dict[str, str]:
    return {"name": scope, "match": rf"\b{_any(words)}\b"}


def _any(words: Any) -> str:
    return f"(?:{'|'.join(sorted(words))})"


def _comparison() -> str:
    return _terminal("COMPARISON")


def _terminal(name: str) -> str:
    pattern: str = parser().get_terminal(name).pattern.value
    return pattern


def main() -> int:
    """Write the file, or compare."""
    text = json.dumps(grammar(), indent=2, ensure_ascii=False) + "\n"
    if "--check" in sys.argv[1:]:
        same = OUT.exists() and OUT.read_text(encoding="utf-8") == text
        if not same:
            print(f"{OUT.name} is not what {Path(__file__).name} makes of the grammar: run it")
        return 0 if same else 1
    OUT.parent.mkdir(parents=True, exist_ok=True)
    OUT.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
