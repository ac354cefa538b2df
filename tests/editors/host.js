// The extension without VS Code: as much of the `vscode` module as it and its client library touch.
// Opens a program, waits for what `nscc lsp` says of it, runs the commands, saves; prints JSON.
//
//     node host.js EXTENSION_FOLDER PROGRAM COMMAND_AS_JSON
"use strict";

const fs = require("node:fs");
const Module = require("node:module");
const os = require("node:os");
const path = require("node:path");
const { fileURLToPath, pathToFileURL } = require("node:url");

const [folder, program, command] = process.argv.slice(2);
const seen = { diagnostics: [], commands: [], opened: [], messages: [] };
const registered = new Map();
const listeners = new Map();

class Position {
  constructor(line, character) { Object.assign(this, { line, character }); }
}
class Range {
  constructor(line, character, endLine, endCharacter) {
    this.start = new Position(line, character);
    this.end = new Position(endLine, endCharacter);
  }
}
class Uri {
  constructor(fsPath) { this.fsPath = fsPath; this.scheme = "file"; this.path = fsPath; }
  static file(fsPath) { return new Uri(fsPath); }
  static parse(text) { return new Uri(fileURLToPath(text)); }
  toString() { return pathToFileURL(this.fsPath).toString(); }
}
const disposable = { dispose() {} };
class EventEmitter {
  heard = [];
  event = (listener) => { this.heard.push(listener); return disposable; };
  fire(value) { for (const listener of this.heard) listener(value); }
  dispose() {}
}
const kind = { append: () => kind };
class CancellationTokenSource {
  token = { isCancellationRequested: false, onCancellationRequested: () => disposable };
  cancel() {}
  dispose() {}
}
const event = (name) => (listener) => {
  listeners.set(name, [...(listeners.get(name) ?? []), listener]);
  return disposable;
};

/** An object that has what is given, and for any other name a class, an event or a function. */
function module_(given) {
  return new Proxy(given, {
    get(known, name) {
      if (!(name in known) && typeof name === "string") {
        if (name.startsWith("on")) known[name] = event(name);
        else if (/^[A-Z]/.test(name)) known[name] = class { constructor(...a) { this.a = a; } };
        else known[name] = () => disposable;
      }
      return known[name];
    },
  });
}

const settings = { command: JSON.parse(command), scene: "builtin:hdr", runOptions: [] };
const text = {
  uri: Uri.file(program), languageId: "nsl", version: 1, fileName: program,
  getText: () => fs.readFileSync(program, "utf8"), save: async () => true,
  isDirty: false, isUntitled: false, isClosed: false,
};
const vscode = module_({
  version: "1.95.0", Position, Range, Uri, EventEmitter, CancellationTokenSource,
  Diagnostic: class { constructor(range, message, severity) { Object.assign(this, { range, message, severity }); } },
  DiagnosticSeverity: { Error: 0, Warning: 1, Information: 2, Hint: 3 },
  ViewColumn: { Beside: -2 }, ExtensionMode: { Production: 1 }, ExtensionKind: { Workspace: 2 },
  CompletionItemKind: {}, SymbolKind: {}, CodeActionKind: new Proxy({}, { get: () => kind }),
  env: module_({ appName: "host", language: "en", machineId: "0" }),
  extensions: { getExtension: () => undefined, all: [] },
  l10n: { t: (said) => said },
  commands: module_({
    registerCommand(name, act) { registered.set(name, act); seen.commands.push(name); return disposable; },
    async executeCommand(name, uri) { if (name === "vscode.open") seen.opened.push(uri.fsPath); },
  }),
  languages: module_({
    createDiagnosticCollection: () => module_({
      set(uri, found) { seen.diagnostics.push((found ?? []).map((each) => [each.code?.value ?? each.code, each.range.start.line])); },
    }),
    match: () => 10,
  }),
  window: module_({
    activeTextEditor: { document: text }, visibleTextEditors: [], terminals: [],
    tabGroups: module_({ get all() { return [{ tabs: seen.opened.map((file) => ({ input: { uri: Uri.file(file) } })) }]; } }),
    createOutputChannel: () => module_({ appendLine() {}, append() {}, show() {}, dispose() {} }),
    async showErrorMessage(said) { seen.messages.push(said); },
    setStatusBarMessage(said) { seen.messages.push(said); },
  }),
  workspace: module_({
    textDocuments: [text], notebookDocuments: [], workspaceFolders: undefined, isTrusted: true,
    getConfiguration: () => ({ get: (name, otherwise) => settings[name] ?? otherwise, has: () => false, inspect: () => undefined }),
    createFileSystemWatcher: () => module_({}),
    getWorkspaceFolder: () => undefined,
    fs: { isWritableFileSystem: () => true },
  }),
});

const load = Module._load;
Module._load = (name, ...rest) => (name === "vscode" ? vscode : load(name, ...rest));

async function until(holds) {
  for (const begin = Date.now(); !holds(); ) {
    if (Date.now() - begin > 180_000) throw new Error(`waited in vain: ${JSON.stringify(seen)}`);
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
}

async function main() {
  const extension = require(path.join(folder, "dist", "extension.js"));
  const storage = fs.mkdtempSync(path.join(os.tmpdir(), "nscc-host-"));
  const context = { subscriptions: [], globalStorageUri: Uri.file(storage), extension: module_({}) };
  await extension.activate(context);
  await until(() => seen.diagnostics.length);
  for (const name of seen.commands.slice()) await registered.get(name)();
  if (seen.messages.some((said) => said.includes("error["))) throw new Error(JSON.stringify(seen));
  const drawn = seen.opened.map((file) => fs.statSync(file).size > 1000);
  for (const file of seen.opened) fs.rmSync(file);
  for (const listener of listeners.get("onDidSaveTextDocument")) listener(text);
  await until(() => seen.opened.every((file) => fs.existsSync(file) && fs.statSync(file).size > 1000));
  await extension.deactivate();
  fs.rmSync(storage, { recursive: true });
  console.log(JSON.stringify({ ...seen, drawn }));
}

main().catch((error) => { console.error(error); process.exit(1); });
