// The editor of the program: CodeMirror with the colours of nsl, and messages at their places.

import {
  bracketMatching, defaultKeymap, drawSelection, EditorState, EditorView, HighlightStyle, history, historyKeymap,
  keymap, lineNumbers, lintGutter, setDiagnostics, StreamLanguage, syntaxHighlighting, tags,
} from "./codemirror.js";

const COLOURS = HighlightStyle.define([
  { tag: tags.comment, class: "remark" },
  { tag: tags.string, class: "text" },
  { tag: tags.number, class: "number" },
  { tag: tags.keyword, class: "statement" },
  { tag: tags.atom, class: "word" },
]);

// `words`: for each version of the language, its statements and all its words.
function language(words) {
  return StreamLanguage.define({
    startState: () => ({ version: 1 }),
    token(stream, state) {
      if (stream.eatSpace()) return null;
      if (stream.match(/#.*/)) return "comment";
      if (stream.match(/"[^"]*"?/)) return "string";
      const version = stream.match(/nsl(?=\s+(\d))/);
      if (version) state.version = Number(version[1]);
      if (version) return "keyword";
      if (stream.match(/\d[\w.]*/)) return "number";
      const word = stream.match(/[A-Za-z_]\w*/)?.[0] ?? stream.next();
      const [statements, all] = words[state.version] ?? words[1];
      return statements.includes(word) ? "keyword" : all.includes(word) && /\w/.test(word) ? "atom" : null;
    },
  });
}

export class Editor {
  constructor(parent, words, changed) {
    this.view = new EditorView({ parent });
    this.extensions = [
      lineNumbers(), history(), drawSelection(), bracketMatching(), lintGutter(),
      language(words), syntaxHighlighting(COLOURS), keymap.of([...defaultKeymap, ...historyKeymap]),
      EditorView.contentAttributes.of({ "aria-label": "program text", spellcheck: "false", autocapitalize: "off" }),
      EditorView.updateListener.of((update) => update.docChanged && changed()),
    ];
    this.open("");
  }

  get text() {
    return this.view.state.doc.toString();
  }

  // Replace the text; the earlier text cannot be brought back by undo.
  open(text) {
    this.view.setState(EditorState.create({ doc: text, extensions: this.extensions }));
  }

  // Underline the places of messages; a message that is pointed at shows its text and its fixes.
  show(messages) {
    const places = messages.filter(({ location }) => location).map((message) => ({
      ...this.range(message),
      severity: message.severity === "note" ? "info" : message.severity,
      message: message.message,
      actions: message.fixes.filter((fix) => fix.location).map((fix) => ({ name: fix.title, apply: () => this.apply(fix) })),
    }));
    this.view.dispatch(setDiagnostics(this.view.state, places));
  }

  // The range of a message or of a fix, whose rows and columns count characters from 1.
  range({ location, end_location: end }) {
    const [from, to] = [location, end].map(({ row, column }) => {
      const line = this.view.state.doc.line(Math.min(row, this.view.state.doc.lines));
      return line.from + [...line.text].slice(0, column - 1).join("").length;
    });
    return { from, to };
  }

  select(message) {
    const { from, to } = this.range(message);
    this.view.dispatch({ selection: { anchor: from, head: to }, scrollIntoView: true });
    this.view.focus();
  }

  apply(fix) {
    this.view.dispatch({ changes: { ...this.range(fix), insert: fix.replacement }, scrollIntoView: true });
    this.view.focus();
  }
}
