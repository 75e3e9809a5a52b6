// The page from `oncard serve`: the session is in the native engine.

import { type ChildProcess, spawn } from "node:child_process";
import { once } from "node:events";
import { existsSync } from "node:fs";
import { resolve } from "node:path";
import { createInterface } from "node:readline";
import { fileURLToPath } from "node:url";

import { expect, test } from "@playwright/test";

import { open, openOwn, runToEnd, status } from "./support.js";

const top = fileURLToPath(new URL("../../../", import.meta.url));
/** The `oncard` that is tested: ONCARD, or that of the last build. */
const oncard = resolve(process.env["ONCARD"] ?? `${top}/build/bin/oncard`);

test.skip(!existsSync(oncard), `there is no ${oncard}: build it, or set ONCARD`);

let server: ChildProcess;
let address: string;

test.beforeEach(async () => {
  const page = fileURLToPath(new URL("../dist/page", import.meta.url));
  const started = spawn(oncard, ["serve", "--page", page], {
    stdio: ["ignore", "pipe", "inherit"],
  });
  server = started;
  [address] = (await once(createInterface(started.stdout), "line")) as [string];
});

test.afterEach(async ({ page }) => {
  await page.close(); // it would ask on
  if (server.exitCode !== null) return;
  const ended = once(server, "exit");
  server.kill("SIGINT");
  expect(await ended).toEqual([0, null]);
});

test("the first program runs in the native engine and is stepped back", async ({ page }) => {
  const asked: string[] = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));
  await open(page, address);
  await openOwn(page);
  await runToEnd(page);
  await expect(page.locator('output[data-axis="1"]')).toHaveText("50000 pulse");
  await page.keyboard.press("F4");
  await expect(page.getByText(/moment 0 of/)).toBeVisible();
  expect(asked.filter((path) => path.endsWith("/sessions/1")).length).toBeGreaterThan(3);
  expect(asked.filter((path) => path.endsWith("oncard.wasm"))).toEqual([]);
});

test("the task is checked by the module, and its counterexample is on the native card", async ({
  page,
}) => {
  await open(page, `${address}#lesson=lost-update`);
  await page.getByRole("button", { name: "Explore" }).click();
  await expect(page.locator(".culprit")).toBeVisible();
  await expect(page.getByText(/moment \d+ of \d+/)).toBeVisible();
});

test("a shared link has neither the secret nor the engine", async ({ page }) => {
  await open(page, address);
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  expect(link).toMatch(/^#p1=/);
  await expect(page.getByText("behind the address of any playground")).toBeVisible();
});

test("a server that has ended is explained", async ({ page }) => {
  await page.goto(`${address}#lesson=assignment`);
  await expect(status(page)).toHaveText("Card ready.");
  server.kill("SIGINT");
  await once(server, "exit");
  await page.keyboard.press("F8");
  await expect(status(page)).toContainText("oncard serve does not answer any more");
});

test("a page that is left ends its session", async ({ page }) => {
  const sessions = new URL("sessions", address).href;
  // With that of the page, these are all that there can be.
  for (let others = 0; others < 15; ++others) {
    expect((await page.request.post(sessions)).ok()).toBe(true);
  }
  await open(page, address);
  expect((await page.request.post(sessions)).status()).toBe(503);
  await page.goto("about:blank");
  await expect.poll(async () => (await page.request.post(sessions)).ok()).toBe(true);
});
