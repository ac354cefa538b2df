// Python with the compiler and the emulator, in a web worker: nothing leaves the browser.

let ready;

async function start(config) {
  const say = (progress, share) => postMessage({ progress, share });
  say(`loading Python from ${config.python}`, 0.05);
  const base = new URL(config.python, self.location.href).href;
  const { loadPyodide } = await import(base + "pyodide.mjs");
  const python = await loadPyodide({ indexURL: base });
  say("loading numpy", 0.45);
  await python.loadPackage("numpy", { messageCallback: () => {}, errorCallback: () => {} });
  if (!python.loadedPackages.numpy) throw new Error(`numpy cannot be loaded from ${base}`);
  say("loading nscc", 0.75);
  const wheel = await fetch(config.wheel);
  if (!wheel.ok) throw new Error(`${config.wheel}: ${wheel.statusText}`);
  python.unpackArchive(await wheel.arrayBuffer(), "wheel");
  say("starting nscc", 0.9);
  return python.runPython(`
import json
from pathlib import Path
from nscc_cli.playground.requests import Playground
playground = Playground(Path("/home/pyodide"))
lambda kind, values: json.dumps(playground.answer(kind, json.loads(values)))
`);
}

onmessage = async ({ data }) => {
  if (data.config) {
    ready = start(data.config);
    ready.catch(() => {}); // told to each request
    return;
  }
  try {
    const answer = await ready;
    postMessage({ id: data.id, answer: JSON.parse(answer(data.kind, JSON.stringify(data.values))) });
  } catch (error) {
    const lines = String(error.message).trim().split("\n");
    const last = lines.findLast((line) => /^\w*(Error|Rejected)\b/.test(line)) ?? lines.at(-1);
    postMessage({ id: data.id, error: `Python in this page: ${last}` });
  }
};
