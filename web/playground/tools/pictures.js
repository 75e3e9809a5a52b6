// Takes the pictures of the documentation with Debian's Chromium.
//   node tools/pictures.js PAGE FOLDER
// PAGE is the folder that bundle.js has made. A font with Chinese characters must be installed.

import { createServer } from "node:http";
import { join, resolve } from "node:path";

import { chromium } from "@playwright/test";
import sirv from "sirv";

const [root = ".", folder = "."] = process.argv.slice(2);
const server = createServer(sirv(resolve(root), { dev: true }));
await new Promise((started) => server.listen(0, "127.0.0.1", started));
const page = `http://127.0.0.1:${server.address().port}/`;
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: process.getuid() === 0 ? ["--no-sandbox"] : [],
});

/** Opens the page, does something there, and writes the picture that `take` has of it. */
async function picture(name, { width, height, colorScheme }, address, act, take = screenshot) {
  const context = await browser.newContext({
    viewport: { width, height },
    colorScheme,
    locale: "en-US",
    // The opening stands still, with its star finished.
    reducedMotion: "reduce",
  });
  const tab = await context.newPage();
  await tab.goto(address);
  await act(tab);
  await take(tab, join(folder, `playground-${name}.png`));
  await context.close();
}

async function screenshot(tab, path) {
  // The panels ask the session for what they draw.
  await tab.waitForTimeout(700);
  await tab.screenshot({ path });
}

/** The picture that the page makes itself. */
async function shared(tab, path) {
  await tab.getByRole("button", { name: "Share" }).click();
  const saved = tab.waitForEvent("download");
  await tab.getByRole("dialog").getByRole("button", { name: "Save the picture" }).click();
  await (await saved).saveAs(path);
}

const finished = (tab) => tab.getByText("Card: finished.").waitFor({ state: "attached" });
const desk = { width: 1440, height: 900 };

const light = { ...desk, colorScheme: "light" };
await picture("light", light, page, finished);
await picture("preview", light, page, finished, shared);
await picture(
  "explore",
  { ...desk, height: 810, colorScheme: "dark" },
  `${page}#lesson=lost-update`,
  async (tab) => {
    await tab.getByText("Card ready.").waitFor({ state: "attached" });
    await tab.getByRole("button", { name: "Explore" }).click();
    await tab.locator("#step-22").click();
    await tab.getByText("after step 22").waitFor();
  },
);
const phone = { width: 390, height: 844, colorScheme: "light" };
await picture("phone", phone, page, async (tab) => {
  await finished(tab);
  await tab.getByRole("button", { name: "Machine" }).click();
});

await browser.close();
server.close();
