// Records of hosts in the page: the module with everything is loaded with the first one.

import { expect, type Page, test } from "@playwright/test";

import {
  atMaximum,
  expectAccessible,
  modulesOf,
  open,
  openOwn,
  runToEnd,
  status,
} from "./support.js";

/** The record of a host that makes these calls to a path card; no card has its state at the end. */
function recordOf(calls: { call: string; in: number[] }[]): string {
  const lines = [
    { oncard: "host calls", format: 1 },
    { open: 0, bare: true, scenario: 'program = ""\ncard = "GE-300-SG"\naxes = 3\n' },
    ...calls.map((call, index) => ({ card: 0, us: 50 * (index + 1), ...call, code: 0 })),
    { close: 0, us: 100_000, hash: "0000000000000000" },
  ];
  return lines.map((each) => `${JSON.stringify(each)}\n`).join("");
}

const drivesOn = [1, 2].map((axis) => ({ call: "GT_AxisOn", in: [axis] }));

const line = recordOf([
  ...drivesOn,
  { call: "GT_SetSynVel", in: [10] },
  { call: "GT_SetSynAcc", in: [1] },
  { call: "GT_LnXY", in: [300, 400] },
]);

/** A list of two lines. */
const corner = recordOf([
  ...drivesOn,
  { call: "GT_StrtList", in: [] },
  { call: "GT_MvXY", in: [0, 0, 10, 1] },
  { call: "GT_LnXY", in: [300, 400] },
  { call: "GT_LnXY", in: [300, 0] },
  { call: "GT_EndList", in: [] },
  { call: "GT_StrtMtn", in: [] },
]);

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
  await expect(page.getByRole("button", { name: "CSV" })).toHaveCount(1);
  await expect(page.getByRole("button", { name: "every cycle" })).toHaveCount(0);
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

test("the path ahead is dotted as far as it is planned", async ({ page }) => {
  await open(page);
  await choose(page, corner);
  await expect(page.getByText("0 of 9 calls made")).toBeVisible();
  const ahead = page.locator(".way-ahead");
  const points = () =>
    ahead.evaluateAll((ways) => ways.map((each) => each.getAttribute("points")?.split(" ").length));
  // Each step is a call or a cycle; with the second axis there is a table.
  await expect
    .poll(async () => {
      await page.keyboard.press("F8");
      return points();
    })
    .toEqual([3]);
  await atMaximum(page);
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(page.locator('output[data-axis="1"]')).toHaveText("300 pulse");
  await expect(ahead).toHaveAttribute("points", "");
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
  await runToEnd(page);
});
