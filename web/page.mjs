// Opens the page in a headless Chromium: node page.mjs FOLDER LINK [X,Y]... prints what the page explains of the sample that
// LINK names, and then of the pixel that a click at each point of the window selects; page.png beside the page shows the end.
// Fails if the console has an error or nothing is explained in time.
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";

const [folder, link, ...clicks] = process.argv.slice(2);
const SECONDS = 60;

const TYPES = { html: "text/html", js: "text/javascript", wasm: "application/wasm" };
const server = createServer((request, response) => {
  const name = new URL(request.url, "http://page").pathname.slice(1) || "index.html";
  try {
    const body = readFileSync(join(folder, name));
    response.writeHead(200, { "Content-Type": TYPES[name.split(".").pop()] ?? "text/plain" }).end(body);
  } catch {
    response.writeHead(404).end();
  }
});
await new Promise((listens) => server.listen(0, "127.0.0.1", listens));

const profile = mkdtempSync(join(tmpdir(), "page-"));
const options = ["--headless=new", "--no-sandbox", "--remote-debugging-pipe", "--enable-unsafe-swiftshader", "--disable-gpu"];
const browser = spawn("chromium", [...options, `--user-data-dir=${profile}`, "--window-size=1400,830"], {
  stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"],
});

// 77: nothing can be said without a browser
let isOpen = false;
function unchecked() {
  if (isOpen) return;
  console.error("chromium does not start: the page is not checked");
  process.exit(77);
}
browser.once("error", unchecked);
browser.once("exit", unchecked);
setTimeout(unchecked, 1000 * SECONDS).unref();

// the protocol of the developer tools: JSON, each message ended by a zero byte
const [, , , to, from] = browser.stdio;
to.on("error", unchecked);
const waiting = new Map();
const problems = [];
let [last, received] = [0, ""];
from.on("data", (bytes) => {
  received += bytes;
  const messages = received.split("\0");
  received = messages.pop();
  for (const text of messages) {
    const { id, method, params, result, error } = JSON.parse(text);
    if (id) waiting.get(id)(error ? Promise.reject(new Error(error.message)) : result);
    if (method === "Runtime.exceptionThrown") problems.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === "Runtime.consoleAPICalled" && params.type === "error") problems.push(params.args.map((it) => it.value ?? it.description).join(" "));
    if (method === "Log.entryAdded" && params.entry.level === "error") problems.push(params.entry.text);
  }
});
let sessionId;
function ask(method, params = {}) {
  last += 1;
  to.write(JSON.stringify({ id: last, method, params, sessionId }) + "\0");
  return new Promise((answers) => waiting.set(last, answers));
}
async function evaluated(expression) {
  const { result } = await ask("Runtime.evaluate", { expression });
  return result.value ?? "";
}
const pause = (seconds) => new Promise((ends) => setTimeout(ends, 1000 * seconds));
async function explained(before, seconds = SECONDS) {
  for (let tries = 0; tries < 20 * seconds; tries += 1) {
    const text = await evaluated("window.groundtruth?.explained()");
    if (text !== "" && text !== before) return text;
    if (problems.length > 0) break;
    await pause(0.05);
  }
  const message = await evaluated("window.groundtruth?.message() ?? document.body.textContent");
  throw new Error(`nothing is explained; the page says: ${message}; ${problems.join("; ")}`);
}

try {
  const { targetId } = await ask("Target.createTarget", { url: "about:blank" });
  ({ sessionId } = await ask("Target.attachToTarget", { targetId, flatten: true }));
  isOpen = true;
  for (const domain of ["Runtime", "Log", "Page"]) await ask(`${domain}.enable`);
  const size = { width: 1400, height: 830, deviceScaleFactor: 1, mobile: false };
  await ask("Emulation.setDeviceMetricsOverride", size);
  const start = performance.now();
  await ask("Page.navigate", { url: `http://127.0.0.1:${server.address().port}/${link}` });
  let text = await explained("");
  console.error(`explained after ${((performance.now() - start) / 1000).toFixed(1)} s`);
  process.stdout.write(text);
  for (const click of clicks) {
    const [x, y] = click.split(",").map(Number);
    // a busy machine may lose a click between two frames: then again
    for (let left = 9, before = text; text === before; left -= 1) {
      for (const type of ["mouseMoved", "mousePressed", "mouseReleased"]) {
        await ask("Input.dispatchMouseEvent", { type, x, y, button: "left", clickCount: 1 });
        await pause(0.1);
      }
      text = await explained(before, 6).catch((error) => {
        if (left === 0) throw error;
        return before;
      });
    }
    process.stdout.write(text);
  }
  for (let tries = 0; tries < SECONDS && (await evaluated("window.groundtruth.busy()")) !== ""; tries += 1) await pause(1);
  const { data } = await ask("Page.captureScreenshot");
  writeFileSync(join(folder, "page.png"), Buffer.from(data, "base64"));
  if (problems.length > 0) throw new Error(problems.join("; "));
} finally {
  browser.kill();
  await new Promise((ends) => browser.once("exit", ends));
  server.close();
  rmSync(profile, { recursive: true, force: true, maxRetries: 20 });
}
