// Chromium over a pipe, by its own protocol: no library, no port, no server.

import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

// A browser without network: whatever asks for an address other than a file's fails, and is written down.
export class Browser {
  static async start(program) {
    const profile = mkdtempSync(join(tmpdir(), "dh-playground-"));
    const child = spawn(program, ["--headless=new", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe", "--no-first-run", "--disable-background-networking",
      "--disable-component-update", "--disable-sync", "--disable-quic", "--disable-dev-shm-usage", "--host-resolver-rules=MAP * ~NOTFOUND", `--user-data-dir=${profile}`, "about:blank"],
    { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    const browser = new Browser();
    Object.assign(browser, { child, profile, number: 0, calls: new Map(), listeners: [] });
    let rest = "";
    child.stdio[4].setEncoding("utf8");
    child.stdio[4].on("data", (text) => {
      const pieces = (rest + text).split("\0");
      rest = pieces.pop();
      for (const piece of pieces) browser.receive(JSON.parse(piece));
    });
    child.on("error", (error) => { throw error; });
    return browser;
  }

  receive(message) {
    const call = this.calls.get(message.id);
    if (call) {
      this.calls.delete(message.id);
      message.error ? call.reject(new Error(`${call.method}: ${message.error.message}`)) : call.resolve(message.result);
    } else for (const listener of this.listeners) listener(message);
  }

  call(method, params = {}, sessionId = undefined) {
    const id = ++this.number;
    this.child.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    return new Promise((resolve, reject) => this.calls.set(id, { method, resolve, reject }));
  }

  async page(url, { width = 1400, height = 900, mobile = false, dark = false } = {}) {
    const { targetId } = await this.call("Target.createTarget", { url: "about:blank" });
    const { sessionId } = await this.call("Target.attachToTarget", { targetId, flatten: true });
    const page = new Page(this, sessionId, targetId);
    this.listeners.push((message) => page.notice(message));
    for (const domain of ["Page", "Runtime", "Network", "Log"]) await page.call(`${domain}.enable`);
    await page.call("Target.setAutoAttach", { autoAttach: true, waitForDebuggerOnStart: false, flatten: true });
    await page.call("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile });
    await page.call("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: dark ? "dark" : "light" }] });
    await page.call("Page.navigate", { url });
    return page;
  }

  async stop() {
    await this.call("Browser.close").catch(() => {});
    await new Promise((resolve) => { this.child.on("exit", resolve); setTimeout(resolve, 3000); });
    // Helpers of the browser may still write there; what is left in the folder for temporary files hurts nobody.
    try { rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 }); } catch { /* next time */ }
  }
}

class Page {
  constructor(browser, session, target) {
    Object.assign(this, { browser, session, target, sessions: new Set([session]), contexts: new Map(), complaints: [], requests: [] });
  }

  // Errors on any console and requests for anything but this file and what the page itself made, of the page, its worker and its frame.
  notice({ method, params, sessionId }) {
    if (!this.sessions.has(sessionId)) return;
    if (method === "Page.frameNavigated" && !params.frame.parentId) this.main = params.frame.id;
    if (method === "Runtime.executionContextCreated" && params.context.auxData?.isDefault) this.contexts.set(params.context.id, { session: sessionId, frame: params.context.auxData.frameId });
    if (method === "Runtime.executionContextDestroyed") this.contexts.delete(params.executionContextId);
    if (method === "Target.attachedToTarget") {
      this.sessions.add(params.sessionId);
      for (const domain of ["Runtime", "Network", "Log"]) this.browser.call(`${domain}.enable`, {}, params.sessionId).catch(() => {});
    }
    if (method === "Runtime.exceptionThrown") this.complaints.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === "Runtime.consoleAPICalled" && ["error", "warning"].includes(params.type)) this.complaints.push(params.args.map((a) => a.value ?? a.description).join(" "));
    if (method === "Log.entryAdded" && ["error", "warning"].includes(params.entry.level)) this.complaints.push(params.entry.text);
    if (method === "Network.requestWillBeSent" && !/^(file|blob|data|about):/.test(params.request.url)) this.requests.push(params.request.url);
  }

  call(method, params = {}, session = this.session) { return this.browser.call(method, params, session); }

  // The value of an expression in the page; promises are waited for.
  value(expression) { return this.evaluate(expression, this.session); }

  // The same in the frame that the page holds.
  inFrame(expression) {
    const [id, context] = [...this.contexts].filter(([, c]) => c.frame !== this.main && c.frame !== undefined).at(-1) ?? [];
    if (id === undefined) return Promise.resolve(undefined);
    return this.evaluate(expression, context.session, { contextId: id });
  }

  async evaluate(expression, session, more = {}) {
    const { result, exceptionDetails } = await this.call("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true, userGesture: true, ...more }, session);
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  // Waits until an expression is true, in the page or in its frame.
  async until(expression, { milliseconds = 240_000, where = "value" } = {}) {
    const end = Date.now() + milliseconds;
    for (;;) {
      // While a document is exchanged for another there is none to ask.
      const found = await this[where](`Boolean(document.body && (${expression}))`).catch((error) => { if (where === "value") throw error; });
      if (found) return;
      if (Date.now() > end) throw new Error(`never true: ${expression}`);
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  }

  async picture() {
    const { data } = await this.call("Page.captureScreenshot", { format: "png" });
    return Buffer.from(data, "base64");
  }

  async key(key, modifiers = 0) {
    for (const type of ["keyDown", "keyUp"]) await this.call("Input.dispatchKeyEvent", { type, key, code: key, modifiers, windowsVirtualKeyCode: { ArrowRight: 39, ArrowLeft: 37, Home: 36, End: 35, Tab: 9 }[key] });
  }

  close() { return this.call("Target.closeTarget", { targetId: this.target }, undefined); }
}
