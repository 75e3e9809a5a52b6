// `./x bench web`: how long the page takes in Chromium, median of five.
//   node tools/measure.js PAGE
// PAGE is the folder that bundle.js has made. The limits are those that learners feel: a second.

import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, resolve } from "node:path";
import { gzipSync } from "node:zlib";

import { chromium } from "@playwright/test";
import lzString from "lz-string";
import sirv from "sirv";

const axes = Array.from({ length: 8 }, (_, index) => index + 1);
const moves = axes.map(
  (axis) =>
    `  GT_AxisOn(${axis});\n  GT_PrfTrap(${axis});\n  GT_SetTrapPrm(${axis}, &trap);\n` +
    `  GT_SetPos(${axis}, 1000000);\n  GT_SetVel(${axis}, 50);\n  GT_Update(${1 << (axis - 1)});\n`,
);
const files = {
  "program.c":
    `TTrapPrm trap;\nint main()\n{\n  trap.acc = 0.25;\n  trap.dec = 0.125;\n` +
    `${moves.join("")}  return 0;\n}\n`,
  "scenario.toml": 'program = "program.c"\nuntil_ms = 10000\n',
};
const project = { lesson: "own", files, program: "program.c", main: "scenario.toml" };
const fragment = `#p1=${lzString.compressToEncodedURIComponent(JSON.stringify(project))}`;

const server = createServer(sirv(resolve(process.argv[2] ?? "."), { dev: true }));
await new Promise((started) => server.listen(0, "127.0.0.1", started));
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: process.getuid() === 0 ? ["--no-sandbox"] : [],
});

/** First paint, and from Run to the last value in the scope, in ms. */
async function once() {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 } });
  const page = await context.newPage();
  await page.goto(`http://127.0.0.1:${server.address().port}/${fragment}`);
  await page.getByText("Card ready.").waitFor();
  await page.getByRole("slider", { name: "Speed" }).press("End");
  for (const axis of axes.slice(2))
    await page.getByLabel("Add a channel").fill(`axis${axis}.prfVel`);
  const times = await page.evaluate(async () => {
    const paint = performance.getEntriesByName("first-contentful-paint")[0]?.startTime ?? NaN;
    const begin = performance.now();
    document.querySelector(".tool.primary").click();
    const frame = () => new Promise((next) => requestAnimationFrame(next));
    const isDrawn = () =>
      document.querySelector(".status-text.good") &&
      document.querySelector(".screen").dataset.toMs === "10000";
    while (!isDrawn()) await frame();
    await frame();
    return { paint, run: performance.now() - begin };
  });
  await context.close();
  return times;
}

const types = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
};

/** First paint, and until the card is there, in s, over 1.6 Mbit/s with 150 ms of delay. */
async function overSlowLine() {
  const compressed = new Map();
  const compressing = createServer((request, response) => {
    const file = request.url === "/" ? "/index.html" : request.url;
    if (!compressed.has(file)) {
      compressed.set(file, gzipSync(readFileSync(join(resolve(process.argv[2] ?? "."), file))));
    }
    response.setHeader("Content-Type", types[extname(file)] ?? "application/octet-stream");
    response.setHeader("Content-Encoding", "gzip");
    response.end(compressed.get(file));
  });
  await new Promise((started) => compressing.listen(0, "127.0.0.1", started));
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 } });
  const page = await context.newPage();
  const line = await context.newCDPSession(page);
  await line.send("Network.enable");
  await line.send("Network.emulateNetworkConditions", {
    offline: false,
    latency: 150,
    downloadThroughput: 200_000,
    uploadThroughput: 200_000,
  });
  await page.goto(`http://127.0.0.1:${compressing.address().port}/#lesson=assignment`);
  // Looked for in each frame: whoever waits outside of the page looks every half a second.
  const isReady = () => document.body.textContent.includes("Card ready.") && performance.now();
  const found = await page.waitForFunction(isReady, undefined, { timeout: 60_000, polling: "raf" });
  const ready = (await found.jsonValue()) / 1000;
  const paint = await page.evaluate(
    () => performance.getEntriesByName("first-contentful-paint")[0]?.startTime / 1000,
  );
  await context.close();
  compressing.close();
  return { paint, ready };
}

const all = [];
for (let time = 0; time < 5; ++time) all.push(await once());
const median = (of) => Math.round(all.map(of).sort((a, b) => a - b)[2]);
console.log(`${"page: first paint".padEnd(46)}${median(({ paint }) => paint)} ms`);
console.log(
  `${"page: 10 s of 8 axes computed and drawn".padEnd(46)}${median(({ run }) => run)} ms`,
);
const slow = await overSlowLine();
console.log(`${"page: first paint over 1.6 Mbit/s".padEnd(46)}${slow.paint.toFixed(1)} s`);
console.log(`${"page: the card is ready over 1.6 Mbit/s".padEnd(46)}${slow.ready.toFixed(1)} s`);
await browser.close();
server.close();
