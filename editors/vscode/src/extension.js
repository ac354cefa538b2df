// Shutter programs in VS Code: starts `nscc lsp`, and shows the pictures that nscc draws beside the
// text. All that is known of the language is known by nscc.
"use strict";

const { execFile } = require("node:child_process");
const { mkdir } = require("node:fs/promises");
const path = require("node:path");
const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

/** What a picture of a program is made by: the arguments of nscc, given the text and the picture. */
const PICTURES = {
  "nscc.view": (text, picture) => ["view", text.fsPath, "-o", picture],
  "nscc.run": (text, picture) => {
    const settings = vscode.workspace.getConfiguration("nscc", text);
    const frame = picture.replace(/\.png$/, ".npz");
    return ["run", text.fsPath, "--scene", settings.get("scene"), "-o", frame, "--png", picture,
      ...settings.get("runOptions")];
  },
};

let client;

async function activate(context) {
  const output = vscode.window.createOutputChannel("nscc");
  const shown = new Map(); // pictures that are drawn anew when their text is saved: how, by picture
  context.subscriptions.push(
    output,
    vscode.commands.registerCommand("nscc.build", () => withText(output, build)),
    ...Object.keys(PICTURES).map((name) =>
      vscode.commands.registerCommand(name, () =>
        withText(output, (text) => show(context, output, shown, name, text)),
      ),
    ),
    vscode.workspace.onDidSaveTextDocument((document) => redraw(output, shown, document.uri)),
  );
  await start(context, output);
}

function deactivate() {
  return client?.stop();
}

/** Start the language server; without one, the colours and the commands are there all the same. */
async function start(context, output) {
  const [command, ...before] = words();
  const watcher = vscode.workspace.createFileSystemWatcher("**/*.{npz,toml}");
  context.subscriptions.push(watcher);
  client = new LanguageClient(
    "nscc",
    "nscc",
    { command, args: [...before, "lsp"] },
    {
      documentSelector: [{ language: "nsl" }, { language: "nscc-asm" }],
      outputChannel: output,
      synchronize: { fileEvents: watcher },
    },
  );
  try {
    await client.start();
  } catch (error) {
    vscode.window.showErrorMessage(
      `nscc cannot be started as '${words().join(" ")}' (${error.message}). ` +
        "Install it, pip install 'nscc[lsp]', or say where it is: the setting nscc.command.",
    );
  }
}

function words() {
  return vscode.workspace.getConfiguration("nscc").get("command");
}

/** Do something with the program in the active editor, saved; what goes wrong is said. */
async function withText(output, act) {
  const document = vscode.window.activeTextEditor?.document;
  if (document?.languageId !== "nsl") {
    vscode.window.showInformationMessage("Open a shutter program (.nsl) first.");
    return;
  }
  if ((document.isDirty || document.isUntitled) && !(await document.save())) {
    return;
  }
  try {
    await act(document.uri, output);
  } catch (error) {
    output.show(true);
    vscode.window.showErrorMessage(error.message);
  }
}

async function build(text, output) {
  await nscc(output, ["build", text.fsPath], text);
  vscode.window.setStatusBarMessage(`built ${path.basename(text.fsPath, ".nsl")}.icw`, 5000);
}

/** Draw a picture and open it beside the text. */
async function show(context, output, shown, name, text) {
  const folder = path.join(context.globalStorageUri.fsPath, name);
  await mkdir(folder, { recursive: true });
  const picture = path.join(folder, `${path.basename(text.fsPath, ".nsl")}.png`);
  await nscc(output, PICTURES[name](text, picture), text);
  shown.set(picture, { name, text });
  const place = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true, preview: false };
  await vscode.commands.executeCommand("vscode.open", vscode.Uri.file(picture), place);
}

/** Draw the pictures of a text anew, those that are still open. */
async function redraw(output, shown, text) {
  const tabs = vscode.window.tabGroups.all.flatMap((group) => group.tabs);
  const open = new Set(tabs.map((tab) => tab.input?.uri?.fsPath));
  for (const [picture, made] of shown) {
    if (!open.has(picture)) {
      shown.delete(picture);
    } else if (made.text.toString() === text.toString()) {
      await nscc(output, PICTURES[made.name](text, picture), text).catch(() => {}); // lsp says why
    }
  }
}

/** Run nscc in the program's folder; what it says goes to the output. Rejects where it fails. */
function nscc(output, args, text) {
  const [command, ...before] = words();
  const options = { cwd: path.dirname(text.fsPath), env: { ...process.env, NO_COLOR: "1" } };
  output.appendLine(`nscc ${args.join(" ")}`);
  return new Promise((resolve, reject) => {
    execFile(command, [...before, ...args], options, (error, stdout, stderr) => {
      output.append(stdout + stderr);
      if (error) {
        const first = stderr.split("\n", 1)[0] || error.message;
        reject(new Error(`nscc ${args[0]}: ${first}`));
      } else {
        resolve();
      }
    });
  });
}

module.exports = { activate, deactivate };
