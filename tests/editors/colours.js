// The scopes that vscode-textmate gives to a program: a JSON line [[row, start, end, scope], ...].
//
//     node colours.js EXTENSION_FOLDER PROGRAM
"use strict";

const fs = require("node:fs");
const path = require("node:path");

const [folder, program] = process.argv.slice(2);
const modules = path.join(folder, "node_modules");
const oniguruma = require(path.join(modules, "vscode-oniguruma"));
const { INITIAL, Registry, parseRawGrammar } = require(path.join(modules, "vscode-textmate"));

async function main() {
  const wasm = fs.readFileSync(path.join(modules, "vscode-oniguruma/release/onig.wasm"));
  await oniguruma.loadWASM(wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength));
  const file = path.join(folder, "syntaxes/nsl.tmLanguage.json");
  const registry = new Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
      createOnigString: (text) => new oniguruma.OnigString(text),
    }),
    loadGrammar: async () => parseRawGrammar(fs.readFileSync(file, "utf8"), file),
  });
  const grammar = await registry.loadGrammar("source.nsl");
  const found = [];
  let stack = INITIAL;
  fs.readFileSync(program, "utf8").split("\n").forEach((line, row) => {
    const { tokens, ruleStack } = grammar.tokenizeLine(line, stack);
    stack = ruleStack;
    for (const { startIndex, endIndex, scopes } of tokens)
      found.push([row, startIndex, endIndex, scopes[scopes.length - 1]]);
  });
  console.log(JSON.stringify(found));
}

main();
