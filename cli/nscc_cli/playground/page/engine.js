// Answers of nscc: from the server of `nscc play`, or from Python in a web worker. Both take the
// requests of nscc_cli/playground/requests.py.

export async function startEngine(progress) {
  const config = await (await fetch("config.json")).json();
  return config.engine === "server" ? new Server() : new InWorker(config, progress);
}

class Server {
  place = "on this computer (nscc play)";
  shared = false; // the address contains a secret word

  async ask(kind, values) {
    const body = JSON.stringify(values);
    const headers = { "Content-Type": "application/json" };
    let response;
    try {
      response = await fetch(kind, { method: "POST", body, headers });
    } catch {
      throw new Error("nscc play does not answer: start it again, and open the address that it prints");
    }
    if (!response.ok) throw new Error(await response.text());
    return response.json();
  }
}

class InWorker {
  shared = true;
  waiting = new Map();
  count = 0;

  constructor(config, progress) {
    this.docs = config.docs;
    this.place = `in this page (Python from ${new URL(config.python, location.href).href})`;
    this.worker = new Worker("worker.js", { type: "module" });
    this.worker.onmessage = ({ data }) => {
      if (data.progress) progress(data.progress, data.share);
      else this.settle(data.id, data.answer, data.error);
    };
    this.worker.onerror = (event) => {
      const error = `the web worker failed: ${event.message || "its file cannot be loaded"}`;
      for (const id of this.waiting.keys()) this.settle(id, null, error);
    };
    this.worker.postMessage({ config });
  }

  settle(id, answer, error) {
    const { resolve, reject } = this.waiting.get(id);
    this.waiting.delete(id);
    if (error) reject(new Error(error));
    else resolve(answer);
  }

  ask(kind, values) {
    const id = ++this.count;
    this.worker.postMessage({ id, kind, values });
    return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
  }
}
