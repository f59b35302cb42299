// The compiler's worker as the page uses it: questions in a row, the last answers kept, stopped when it takes too long.

// Milliseconds: a question that is no longer wanted is left running so long, any question so long.
const PATIENCE = 200, LIMIT = 120_000;

// An answer that never came: the question was dropped, stopped, or the worker broke.
class Stopped extends Error {
  constructor(why) { super(why); this.why = why; }
}

class Compiler {
  // `onbusy(since)` is told when a question is worked on, and `onbusy(null)` when none is.
  constructor(module, source, onbusy) {
    this.module = module;
    this.source = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    this.onbusy = onbusy;
    this.waiting = [];
    this.running = null;
    this.answers = new Map();
    this.number = 0;
    this.start();
  }

  start() {
    this.worker = new Worker(this.source);
    this.worker.onmessage = ({ data }) => this.receive(data);
    this.worker.onerror = (event) => { event.preventDefault(); this.restart("broken"); };
    this.worker.postMessage({ module: this.module });
  }

  // The answer to a question; rejects with `Stopped`.
  ask(question) {
    const text = JSON.stringify(question), known = this.answers.get(text);
    if (known) return Promise.resolve(known);
    return new Promise((resolve, reject) => {
      this.waiting.push({ text, resolve, reject });
      this.next();
    });
  }

  next() {
    if (this.running || this.waiting.length === 0) return;
    const job = this.waiting.shift();
    this.running = Object.assign(job, { id: ++this.number, since: performance.now(), timer: setTimeout(() => this.restart("timeout"), LIMIT) });
    this.worker.postMessage({ id: job.id, question: job.text });
    this.onbusy(job.since);
  }

  receive({ id, answer, failed }) {
    const job = this.running;
    if (!job || job.id !== id) return;
    if (failed) return this.restart("broken");
    clearTimeout(job.timer);
    this.running = null;
    this.onbusy(null);
    const value = JSON.parse(answer);
    this.answers.set(job.text, value);
    // The oldest goes; a question holds its table, so this is bounded by a few tables' answers.
    if (this.answers.size > 24) this.answers.delete(this.answers.keys().next().value);
    job.resolve(value);
    this.next();
  }

  // What was asked about an earlier table is no longer wanted.
  drop() {
    for (const job of this.waiting.splice(0)) job.reject(new Stopped("dropped"));
    if (this.running && performance.now() - this.running.since > PATIENCE) this.restart("dropped");
  }

  restart(why) {
    const job = this.running;
    this.worker.terminate();
    if (job) clearTimeout(job.timer);
    this.running = null;
    this.onbusy(null);
    this.start();
    job?.reject(new Stopped(why));
    this.next();
  }
}

// The module as it stands in this file: base64 of gzip.
async function unpack(text) {
  const bytes = Uint8Array.from(atob(text.trim()), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}
