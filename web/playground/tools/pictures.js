// Takes the pictures of the documentation with Debian's Chromium.
//   node tools/pictures.js PAGE FOLDER
// PAGE is the folder that bundle.js has made.

import { createServer } from "node:http";
import { join, resolve } from "node:path";

import { chromium } from "@playwright/test";
import sirv from "sirv";

const [page = ".", folder = "."] = process.argv.slice(2);
const server = createServer(sirv(resolve(page), { dev: true }));
await new Promise((started) => server.listen(0, "127.0.0.1", started));
const address = `http://127.0.0.1:${server.address().port}/`;
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: process.getuid() === 0 ? ["--no-sandbox"] : [],
});

async function take(name, { width, height, colorScheme }, lesson, act) {
  const context = await browser.newContext({
    viewport: { width, height },
    colorScheme,
    locale: "en-US",
  });
  const tab = await context.newPage();
  await tab.goto(`${address}#lesson=${lesson}`);
  await tab.getByText("Card ready.").waitFor();
  await act(tab);
  // The panels ask the session for what they draw.
  await tab.waitForTimeout(700);
  await tab.screenshot({ path: join(folder, `playground-${name}.png`) });
  await context.close();
}

const run = async (tab) => {
  await tab.getByLabel("Speed").selectOption("Infinity");
  await tab.getByRole("button", { name: "Run", exact: true }).click();
  await tab.getByText("Card: finished.").waitFor();
};
const desktop = { width: 1280, height: 720 };

await take("light", { ...desktop, colorScheme: "light" }, "own", async (tab) => {
  await run(tab);
  await tab.getByRole("checkbox", { name: "Cursors" }).check();
});
await take(
  "explore",
  { ...desktop, height: 680, colorScheme: "dark" },
  "lost-update",
  async (tab) => {
    await tab.getByRole("button", { name: "Explore" }).click();
    await tab.locator(".culprit").waitFor();
  },
);
const phone = { width: 390, height: 844, colorScheme: "light" };
await take("phone", phone, "own", async (tab) => {
  await run(tab);
  await tab.getByRole("button", { name: "Machine" }).click();
});

await browser.close();
server.close();
