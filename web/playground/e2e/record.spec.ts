// Records of hosts in the page: the module with everything is loaded with the first one.

import { expect, type Page, test } from "@playwright/test";

import { atMaximum, expectAccessible, modulesOf, open, openOwn, status } from "./support.js";

/** A host that lets two axes of a path card draw a line; no card has its state at the end. */
const line = [
  { oncard: "host calls", format: 1 },
  { open: 0, bare: true, scenario: 'program = ""\ncard = "GE-300-SG"\naxes = 3\n' },
  ...[
    { call: "GT_AxisOn", in: [1] },
    { call: "GT_AxisOn", in: [2] },
    { call: "GT_SetSynVel", in: [10] },
    { call: "GT_SetSynAcc", in: [1] },
    { call: "GT_LnXY", in: [300, 400] },
  ].map((call, index) => ({ card: 0, us: 50 * (index + 1), ...call, code: 0 })),
  { close: 0, us: 100_000, hash: "0000000000000000" },
]
  .map((each) => `${JSON.stringify(each)}\n`)
  .join("");

async function choose(page: Page, text: string): Promise<void> {
  await page
    .locator("input[type=file]")
    .setInputFiles({ name: "line.calls", mimeType: "text/plain", buffer: Buffer.from(text) });
}

test("a record of a GE card moves its axes, and the program comes back", async ({ page }) => {
  const modules = modulesOf(page);
  await open(page);
  expect(modules).toEqual(["oncard.wasm"]);
  await choose(page, line);
  await expect(page.getByText("0 of 6 calls made")).toBeVisible();
  expect(modules).toEqual(["oncard.wasm", "oncard-full.wasm"]);
  await expect(page.getByRole("button", { name: "Explore" })).toBeDisabled();
  await expectAccessible(page);
  await page.keyboard.press("F8");
  await expect(page.getByText("GT_AxisOn(1) = 0")).toBeVisible();
  await atMaximum(page);
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(status(page)).toContainText("Other than recorded");
  await expect(page.locator('output[data-axis="1"]')).toHaveText("300 pulse");
  await expect(page.locator('output[data-axis="2"]')).toHaveText("400 pulse");
  await page.getByRole("button", { name: "Back to the program" }).click();
  await expect(page.getByRole("textbox", { name: /^Text of/ })).toBeVisible();
  await expect(status(page)).toHaveText("Card ready.");
});

test("without the module with everything the program stays on the card", async ({ page }) => {
  await open(page);
  await page.route("**/oncard-full.wasm", (route) => route.fulfill({ status: 503 }));
  page.removeAllListeners("console"); // the browser reports the failure
  await choose(page, line);
  await expect(status(page)).toContainText("Records of hosts cannot be opened");
  await page.unroute("**/oncard-full.wasm");
  await choose(page, line);
  await expect(page.getByText("0 of 6 calls made")).toBeVisible();
});

test("what is no record is refused, and the program is there", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await choose(page, "this is no record");
  await expect(status(page)).toContainText("line.calls");
  await atMaximum(page);
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(status(page)).toHaveText("Card: finished.");
});
