// The worker: the compiler in WebAssembly, one question after the other. Questions and answers are text; what they say is not its business.
"use strict";
let ready = null;

onmessage = async ({ data }) => {
  try {
    if (data.module) {
      ready = WebAssembly.instantiate(data.module, {});
      return;
    }
    const compiler = (await ready).exports;
    const question = new TextEncoder().encode(data.question);
    const at = compiler.dh_question(question.length);
    new Uint8Array(compiler.memory.buffer, at, question.length).set(question);
    const found = compiler.dh_answer();
    const answer = new Uint8Array(compiler.memory.buffer, found, compiler.dh_answer_length());
    postMessage({ id: data.id, answer: new TextDecoder().decode(answer) });
  } catch (error) {
    // Out of memory or out of stack: the page starts another worker.
    postMessage({ id: data.id, failed: String(error) });
  }
};
