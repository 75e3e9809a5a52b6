// The failing run of an exploration as a table: what it says, and where it leads.

import { expect, type Locator, type Page, test } from "@playwright/test";

import { editor, expectAccessible, open, openOwn, status, write } from "./support.js";

const table = (page: Page): Locator => page.getByRole("grid", { name: /Failing run|失败的运行/ });
const row = (page: Page, step: number): Locator => page.locator(`#step-${step}`);
const now = (page: Page): Locator => page.locator(".now-pill");

async function exploreLostUpdate(page: Page): Promise<void> {
  await open(page, "#lesson=lost-update");
  await page.getByRole("button", { name: /Explore|探索/ }).click();
  await expect(row(page, 32).or(row(page, 29))).toHaveAttribute("aria-selected", "true");
}

test("the table has a column for each thread, and each value before and after", async ({
  page,
}) => {
  await exploreLostUpdate(page);
  const panel = page.locator("#interleaving");
  await expect(panel.getByRole("heading", { level: 3 })).toHaveText("parts is 12, expected 15");
  await expect(table(page).getByRole("columnheader")).toHaveText([
    "step",
    "0 count",
    "1 count",
    "parts",
  ]);
  const cells = (step: number) => row(page, step).getByRole("gridcell");
  await expect(cells(1)).toHaveText(["1", /copy = parts;.*copy 10/, "", /reads 10/]);
  await expect(cells(4)).toHaveText(["4", "", "parts = copy;", /10 → 11/]);
  await expect(cells(5)).toHaveText(["5–7", "", "3 statements, nothing shared", ""]);
  await expect(row(page, 22).locator(".lost")).toHaveText("13 → 11");
  // What is lost is lost after step 2.
  const order = await table(page).getByRole("row").allTextContents();
  const band = order.findIndex((text) => text.includes("every continuation fails"));
  expect(order[band - 1]).toMatch(/^2/);
  await expect(page.locator(".stale-words")).toHaveText(
    "Thread 0 keeps the old 10while thread 1 makes it 13.",
  );
  await expectAccessible(page);
});

test("an arrow leads from the stale read to the lost write", async ({ page }) => {
  await exploreLostUpdate(page);
  const boxOf = async (place: Locator) => {
    const box = await place.boundingBox();
    if (!box) throw new Error("it is not drawn");
    return box;
  };
  const arrow = await boxOf(page.locator(".stale-arrow path").first());
  const middle = (box: { y: number; height: number }) => box.y + box.height / 2;
  const read = await boxOf(row(page, 1));
  const lost = await boxOf(row(page, 22));
  expect(Math.abs(arrow.y - middle(read))).toBeLessThan(6);
  expect(Math.abs(arrow.y + arrow.height - middle(lost))).toBeLessThan(6);
});

test("a row leads to its step: timeline, values and editor follow", async ({ page }) => {
  await exploreLostUpdate(page);
  const parts = page.getByLabel("Change parts", { exact: true });
  await row(page, 16).click();
  await expect(row(page, 16)).toHaveAttribute("aria-selected", "true");
  await expect(now(page)).toHaveText("after step 16");
  await expect(parts).toHaveValue("13");
  await row(page, 22).click();
  await expect(parts).toHaveValue("11");
  await expect(page.locator(".cm-next")).toContainText("n = n - 1;");
  // A row of several steps leads to after the last one.
  await row(page, 5).click();
  await expect(now(page)).toHaveText("after step 7");
});

test("a link leads to a step of the failing run", async ({ page, browser }) => {
  await exploreLostUpdate(page);
  await row(page, 22).click();
  const parts = page.getByLabel("Change parts", { exact: true });
  await expect(parts).toHaveValue("11");
  await page.getByRole("button", { name: "Share" }).click();
  await expect(page.getByLabel(/^at moment/)).toBeChecked();
  const other = await (await browser.newContext()).newPage();
  await other.goto(await page.getByRole("textbox", { name: "Link" }).inputValue());
  await expect(other.getByLabel("Change parts", { exact: true })).toHaveValue("11");
  await expect(other.locator(".cm-next")).toContainText("n = n - 1;");
  await other.context().close();
});

test("the timeline has the numbers of the table", async ({ page }) => {
  await exploreLostUpdate(page);
  const numbers = page.locator(".lane-step");
  await expect(numbers).toHaveCount(32);
  await expect(page.locator(".lane-step.hit")).toHaveText(["1", "22"]);
  await expect(page.locator(".lane.t0 .lane-step").nth(1)).toHaveText("21");
  await expect(page.locator(".fatal-line")).toHaveCount(1);
});

test("the arrows go through the steps, and what steps does moves the row", async ({ page }) => {
  await exploreLostUpdate(page);
  await table(page).focus();
  await page.keyboard.press("Home");
  await expect(row(page, 1)).toHaveAttribute("aria-selected", "true");
  await page.keyboard.press("ArrowDown");
  await expect(row(page, 2)).toHaveAttribute("aria-selected", "true");
  await expect(table(page)).toHaveAttribute("aria-activedescendant", "step-2");
  await page.keyboard.press("F8");
  await expect(row(page, 3)).toHaveAttribute("aria-selected", "true");
  await page.keyboard.press("End");
  await expect(row(page, 29)).toHaveAttribute("aria-selected", "true");
});

test("after another choice the table says nothing of the card, and leads back", async ({
  page,
}) => {
  await exploreLostUpdate(page);
  await row(page, 1).click();
  await expect(row(page, 1)).toHaveAttribute("aria-selected", "true");
  await page.getByRole("button", { name: /^Let thread 0 / }).click();
  await expect(page.locator("#interleaving tr.now")).toHaveCount(0);
  await expect(page.locator(".lane-step")).toHaveCount(0);
  await row(page, 22).click();
  await expect(row(page, 22)).toHaveAttribute("aria-selected", "true");
  await expect(page.getByLabel("Change parts", { exact: true })).toHaveValue("11");
});

test("an edit takes the table away", async ({ page }) => {
  await exploreLostUpdate(page);
  await editor(page).press("Control+End");
  await page.keyboard.type(" ");
  await expect(page.locator("#interleaving")).toHaveCount(0);
});

test("what repeats for ever is said, and goes on counting", async ({ page }) => {
  await open(page, "#lesson=lock");
  await page.getByRole("button", { name: "Explore" }).click();
  await expect(table(page)).toContainText("And then for ever:");
  const numbers = await table(page).locator("td.number").allTextContents();
  expect(numbers).toEqual(numbers.map((_, index) => String(index + 1)));
  await row(page, numbers.length).click();
  await expect(row(page, numbers.length)).toHaveAttribute("aria-selected", "true");
  await expect(page.locator(".stale-arrow")).toHaveCount(0);
});

test("passes of a loop are one row", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await write(
    page,
    "int x;\nint main()\n{\n  int i;\n  int m;\n  i = 5;\nagain:\n  x = x + 1;\n  i = i - 1;\n" +
      "  m = i > 0;\n  if (m) goto again;\n}\n",
  );
  await page.getByRole("button", { name: "scenario.toml" }).click();
  await write(page, 'program = "program.c"\nfinal = ["x == 9"]\n');
  await expect(page.getByText("No messages")).toBeVisible();
  await page.getByRole("button", { name: "Explore" }).click();
  const passes = table(page).getByRole("row").filter({ hasText: "× 4 more" });
  await expect(passes).toContainText("1 → 5");
  await passes.click();
  await expect(passes).toHaveAttribute("aria-selected", "true");
});

test("both orders of a data race stand side by side", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await write(
    page,
    "int y;\nint z;\nint give()\n{\n  y = 200;\n}\nint take()\n{\n  int got;\n  got = y;\n  z = got;\n}\n",
  );
  await page.getByRole("button", { name: "scenario.toml" }).click();
  await write(
    page,
    'program = "program.c"\nraces = "none"\n[[thread]]\nfunction = "give"\n' +
      '[[thread]]\nthread = 1\nfunction = "take"\n',
  );
  await expect(page.getByText("No messages")).toBeVisible();
  await page.getByRole("button", { name: "Explore" }).click();
  await page.getByRole("button", { name: "Both", exact: true }).click();
  const order = (thread: number) => page.getByRole("region", { name: `Thread ${thread} first` });
  await expect(order(0).getByRole("heading")).toContainText("at the end z = 200");
  await expect(order(1).getByRole("heading")).toContainText("at the end z = 0");
  await expect(order(0).locator(".hit")).toHaveText([/y = 200;/, /got = y;/]);
  await expect(order(1).locator(".hit")).toHaveText([/got = y;/, /y = 200;/]);
  await expectAccessible(page);
  await page.getByRole("button", { name: "This order" }).click();
  await expect(table(page)).toBeVisible();
});

test("it is in Chinese, and accessible in the dark", async ({ page }) => {
  await page.emulateMedia({ colorScheme: "dark", reducedMotion: "reduce" });
  await open(page, "#lesson=lost-update");
  await page.getByRole("button", { name: /Chinese/ }).click();
  await page.getByRole("button", { name: "探索" }).click();
  await expect(table(page)).toContainText("从这里起，怎样继续都会失败。");
  await expect(page.locator("#interleaving h3")).toHaveText("parts 为 12，应为 15");
  await expect(now(page)).toHaveText("第 32 步之后");
  await expectAccessible(page);
});

test.describe("on a phone", () => {
  test.use({ viewport: { width: 390, height: 844 } });

  test("the table comes to the front, and the lesson is there when it goes", async ({ page }) => {
    await open(page, "#lesson=lost-update");
    await page.getByRole("button", { name: "Explore" }).click();
    await expect(table(page)).toBeVisible();
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
    await row(page, 22).click();
    await expect(row(page, 22)).toHaveAttribute("aria-selected", "true");
    await expectAccessible(page);
    await page.evaluate(() => {
      location.hash = "#lesson=loops";
    });
    await expect(page.locator("#lesson")).toBeVisible();
    await expect(page.locator("#interleaving")).toHaveCount(0);
    await expect(status(page)).toHaveText("Card ready.");
  });
});
