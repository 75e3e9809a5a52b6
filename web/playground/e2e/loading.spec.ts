// What comes with the page: the module, and what others see of it.

import { expect, test } from "@playwright/test";

import { modulesOf, open, status } from "./support.js";

test("the module is compiled while it comes, and fetched once, for checks, too", async ({
  page,
}) => {
  const modules = modulesOf(page);
  await page.addInitScript(() => {
    const compile = WebAssembly.compileStreaming.bind(WebAssembly);
    Object.assign(globalThis, { streams: 0 });
    WebAssembly.compileStreaming = (source) => {
      ++(globalThis as unknown as { streams: number }).streams;
      return compile(source);
    };
  });
  await open(page);
  await page.getByRole("button", { name: "Check" }).click();
  await expect(page.locator(".verdict")).toContainText("Not yet.");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(status(page)).toContainText("Finished, but");
  expect(modules).toEqual(["oncard.wasm"]);
  const streams = await page.evaluate(() => (globalThis as unknown as { streams: number }).streams);
  expect(streams).toBe(1);
});

test("a module is also taken from a server that does not know its type", async ({ page }) => {
  await page.route("**/oncard.wasm", async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, headers: { "Content-Type": "application/octet-stream" } });
  });
  await open(page);
});

test("the script of the worker comes beside the module", async ({ page }) => {
  const script = page.waitForRequest("**/worker.js");
  await page.route("**/oncard.wasm", async (route) => {
    await script;
    await route.continue();
  });
  await open(page);
});

test("without that script the page says what is missing, before it has the module", async ({
  page,
}) => {
  await page.route("**/worker.js", (route) => route.fulfill({ status: 404 }));
  await page.route("**/oncard.wasm", () => undefined); // it never comes
  await page.goto(".");
  await expect(status(page)).toContainText("worker.js cannot be fetched");
});

test("links to the page have a preview, which lies beside it", async ({ page, request }) => {
  await page.goto(".");
  const of = (name: string) => page.locator(`meta[property="og:${name}"]`).getAttribute("content");
  const answer = await request.get((await of("image")) ?? "");
  expect(answer.headers()["content-type"]).toBe("image/png");
  const picture = await answer.body();
  const size = [picture.readUInt32BE(16), picture.readUInt32BE(20)].map(String);
  expect([await of("image:width"), await of("image:height")]).toEqual(size);
  // Some networks leave out larger ones.
  expect(picture.length).toBeLessThan(300_000);
});
