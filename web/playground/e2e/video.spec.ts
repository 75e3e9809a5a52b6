// The picture of a run, which the dialog for sharing has.

import { readFile } from "node:fs/promises";

import { expect, type Locator, type Page, test } from "@playwright/test";

import { atMaximum, expectAccessible, open, openOwn, status } from "./support.js";

/** Runs two axes, one after the other, for 2.5 s. */
async function run(page: Page): Promise<void> {
  await open(page);
  await openOwn(page);
  await atMaximum(page);
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(status(page)).toHaveText("Card: finished.");
}

async function share(page: Page): Promise<Locator> {
  await page.getByRole("button", { name: "Share" }).click();
  return page.getByRole("region", { name: "Picture" });
}

async function saved(page: Page, button: Locator): Promise<{ name: string; content: Buffer }> {
  const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
  return { name: download.suggestedFilename(), content: await readFile(await download.path()) };
}

test("the picture has the same size whatever the screen, and can be copied", async ({
  browser,
}) => {
  const context = await browser.newContext({
    deviceScaleFactor: 2,
    permissions: ["clipboard-read", "clipboard-write"],
  });
  const page = await context.newPage();
  await run(page);
  const part = await share(page);
  await expect(part.getByRole("img", { name: "Machine and scope at 2500 ms" })).toBeVisible();
  const { name, content } = await saved(
    page,
    part.getByRole("button", { name: "Save the picture" }),
  );
  expect(name).toBe("oncard.png");
  expect(content.subarray(1, 4).toString()).toBe("PNG");
  // Width and height stand in the first part of the file.
  expect([content.readUInt32BE(16), content.readUInt32BE(20)]).toEqual([1280, 720]);
  await part.getByRole("button", { name: "Copy the picture" }).click();
  await expect(part.getByText("Copied.")).toBeVisible();
  const types = await page.evaluate(async () =>
    (await navigator.clipboard.read()).flatMap((item) => item.types),
  );
  expect(types).toEqual(["image/png"]);
  await context.close();
});

test("before a run there is nothing to show", async ({ page }) => {
  await open(page);
  await openOwn(page);
  const part = await share(page);
  const button = part.getByRole("button", { name: "Save the picture" });
  await expect(button).toBeDisabled();
  await expect(button).toHaveAccessibleDescription(/run the program first/);
  await expectAccessible(page);
});
