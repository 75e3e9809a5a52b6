// C beside what it becomes on the card.

import { expect, type Locator, type Page, test } from "@playwright/test";

import { editor, expectAccessible, open, openOwn, write } from "./support.js";

const counting =
  "//@ structured\nint total;\n\nint main()\n{\n" +
  "  for (int i = 0; i < 3; i++) {\n    total += 2 * i + 1; // adds\n  }\n  return total;\n}\n";

const rows = (page: Page) => page.locator(".two-columns tbody tr");

/** The row with this line of C. */
const rowOf = (page: Page, line: number) =>
  rows(page).filter({ has: page.getByRole("button", { name: String(line), exact: true }) });

async function show(page: Page): Promise<void> {
  await page.getByRole("button", { name: "C and card" }).click();
}

/** Where the parts of a row begin. */
async function placesOf(row: Locator): Promise<{ x: number; y: number }[]> {
  return row.locator("code").evaluateAll((parts) =>
    parts.map((part) => {
      const { x, y } = part.getBoundingClientRect();
      return { x, y };
    }),
  );
}

test("structured C stands beside what it becomes, and follows edits", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await write(page, counting);
  await show(page);
  const total = rowOf(page, 7);
  await expect(total.locator("code")).toHaveText([
    "    total += 2 * i + 1; // adds",
    "  tmp1 = 2 * i;",
  ]);
  // The parts of the loop stand where they are executed; what is shown again is paler.
  await expect(rowOf(page, 6)).toHaveCount(2);
  await expect(rowOf(page, 6).nth(1)).toHaveClass(/again/);

  await test.step("a click at a row shows its line, also at one without a line of its own", async () => {
    await total.click();
    await expect(page.locator(".cm-linked")).toHaveText("    total += 2 * i + 1; // adds");
    await expect(total).toHaveClass(/linked/);
    await rowOf(page, 9).getByRole("button").press("Enter");
    await expect(page.locator(".cm-linked")).toHaveText("  return total;");
    await rows(page).filter({ hasText: "total = total +" }).click();
    await expect(page.locator(".cm-linked")).toHaveText("    total += 2 * i + 1; // adds");
  });

  await test.step("the line that the card executes next is marked", async () => {
    await page.keyboard.press("F8");
    await expect(page.locator(".two-columns .next").first()).toContainText("for (int i = 0");
    await page.keyboard.press("F4");
  });

  await test.step("mistakes keep the rows before, in grey", async () => {
    await write(page, counting.replace("+ 1;", "+ ;"));
    const said = page.getByText("There are errors: this is from before.");
    await expect(said).toBeVisible();
    await expect(total).toContainText("2 * i");
    await expectAccessible(page);
    await write(page, counting.replace("2 * i", "3 * i"));
    await expect(said).toHaveCount(0);
    await expect(total).toContainText("3 * i");
  });

  await test.step("what is in the card's C already becomes nothing else", async () => {
    await write(page, "int x;\nint main()\n{\n  x = 1;\n}\n");
    await expect(page.getByText("This program is in the card's own C")).toBeVisible();
    await expect(rows(page)).toHaveCount(0);
    await page.getByRole("button", { name: /中文|Chinese/ }).click();
    await expect(page.getByText("此程序已是卡的 C 语言")).toBeVisible();
  });
});

test("the pointer links C, the statements of the card and their instruction words", async ({
  page,
}) => {
  await open(page);
  await openOwn(page);
  await write(page, counting);
  await page.keyboard.press("F8");
  const line = page.locator(".cm-line").filter({ hasText: "total += 2 * i + 1" });
  const pointedLine = page.locator(".cm-pointed");

  await test.step("at a line of C: what it becomes", async () => {
    await page.getByRole("button", { name: "Statements" }).click();
    await line.hover();
    const statements = page.locator(".listing .pointed code");
    await expect(statements.first()).toContainText("tmp1 := 2 * i");
    expect(await statements.count()).toBeGreaterThan(2);
    await show(page);
    await line.hover();
    await expect(page.locator(".two-columns .pointed").first()).toContainText("total += 2 * i + 1");
    // The line itself is under the pointer: nothing need say which one it is.
    await expect(pointedLine).toHaveCount(0);
  });

  await test.step("at what it becomes: the line of C", async () => {
    await rows(page).filter({ hasText: "total = total +" }).hover();
    await expect(pointedLine).toHaveText("    total += 2 * i + 1; // adds");
    await page.getByRole("button", { name: "Statements" }).click();
    await expect(pointedLine).toHaveCount(0);
    await page
      .locator(".listing tr")
      .filter({ hasText: "tmp1 := 2 * i" })
      .locator(".words")
      .hover();
    await expect(pointedLine).toHaveText("    total += 2 * i + 1; // adds");
    await page.mouse.move(0, 0);
    await expect(pointedLine).toHaveCount(0);
  });
});

test("a line of an included file is shown in that file", async ({ page }) => {
  const files = {
    "program.c": '//@ structured\n#include "twice.h"\nint main()\n{\n  return twice(x);\n}\n',
    "twice.h": "int x;\nint twice(int n) { return n * 2; }\n",
    "scenario.toml": 'program = "program.c"\n',
  };
  await page.addInitScript(
    (shelf) => {
      localStorage.setItem("oncard.shelf.own", shelf);
    },
    JSON.stringify({ open: 0, programs: [files] }),
  );
  await open(page, "#lesson=own");
  await show(page);
  await expect(page.locator(".two-columns th[colspan]").first()).toHaveText("twice.h");
  await rows(page).filter({ hasText: "int twice(int n)" }).click();
  await expect(page.getByRole("button", { name: "twice.h" })).toHaveAttribute(
    "aria-pressed",
    "true",
  );
  await expect(editor(page)).toContainText("return n * 2");
});

for (const { width, beside } of [
  { width: 1440, beside: true },
  { width: 390, beside: false },
]) {
  test(`at ${width} pixels the card is ${beside ? "beside" : "below"} C`, async ({ page }) => {
    await open(page, "#lesson=own");
    await write(page, counting);
    await page.setViewportSize({ width, height: 844 });
    if (width < 760) {
      await page.getByRole("navigation").getByRole("button", { name: "Values" }).click();
    }
    await show(page);
    const row = rowOf(page, 7);
    await expect(row.locator("code")).toHaveCount(2);
    const [c, card] = await placesOf(row);
    if (!c || !card) throw new Error("there are no columns");
    if (beside) {
      expect(card.y).toBe(c.y);
      expect(card.x).toBeGreaterThan(c.x + 150);
    } else {
      expect(card.y).toBeGreaterThan(c.y);
      expect(card.x).toBeGreaterThan(c.x);
      expect(card.x).toBeLessThan(c.x + 50);
    }
    const list = page.getByRole("group", { name: "C and card" });
    const wide = await list.evaluate((each) => each.scrollWidth - each.clientWidth);
    expect(wide).toBeLessThanOrEqual(0);
    await expectAccessible(page);
    await row.getByRole("button").click();
    await expect(editor(page)).toBeVisible();
    await expect(page.locator(".cm-linked")).toHaveText("    total += 2 * i + 1; // adds");
  });
}
