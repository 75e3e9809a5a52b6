// What a teacher does: a lesson is written, and its link given to a student.

import { expect, test } from "@playwright/test";

import { editor, expectAccessible, fromMenu, open, openOwn, status, write } from "./support.js";

test("a lesson is written, and a student solves it", async ({ page, browser }) => {
  await open(page);
  await openOwn(page);
  await write(page, "int x;\nint main()\n{\n  x = 4;\n}\n");
  await page.getByRole("button", { name: "scenario.toml" }).click();
  await write(page, 'program = "program.c"\nexpect = ["x == 3"]\n');
  await expect(page.getByText("No messages")).toBeVisible();

  await fromMenu(page, "Make a lesson");
  const dialog = page.getByRole("dialog", { name: "Make a lesson of this program" });
  await expect(dialog.getByRole("status")).toContainText("title.en the text is empty");
  const link = dialog.getByRole("textbox", { name: "Link" });
  await expect(link).toHaveCount(0);
  await dialog.getByLabel("Title").fill("Three");
  await dialog
    .getByLabel("Text, in Markdown")
    .fill("Let `x` become **3**, not 1&frac12; or &nonsense; [Words](https://bücher.example/ü).");
  await dialog.getByRole("button", { name: "Add a hint" }).click();
  await dialog.getByLabel("Hint 1 of 1").fill("Write `x = 3;`.");
  await expectAccessible(page);
  const address = await link.inputValue();

  const student = await (await browser.newContext()).newPage();
  await open(student);
  await student.goto(address);
  const lesson = student.getByRole("group", { name: "Three" });
  await expect(lesson.locator("strong")).toHaveText("3");
  await expect(lesson).toContainText("not 1½ or &nonsense;");
  await expect(lesson.getByRole("link", { name: "Words" })).toHaveAttribute(
    "href",
    "https://xn--bcher-kva.example/%C3%BC",
  );
  await lesson.getByRole("button", { name: "Show a hint" }).click();
  await expect(lesson).toContainText("Write x = 3;.");
  await expect(editor(student)).toContainText("x = 4;");
  await student.getByRole("button", { name: "Check" }).click();
  await expect(student.locator(".verdict")).toContainText("Not yet. This does not hold:");
  await write(student, "int x;\nint main()\n{\n  x = 3;\n}\n");
  await student.getByRole("button", { name: "Check" }).click();
  await expect(student.locator(".verdict")).toContainText("Solved.");
  await student.context().close();

  // What was written stays, and the card goes on.
  await dialog.getByRole("button", { name: "Close" }).click();
  await page.reload();
  await expect(status(page)).toHaveText("Card ready.");
  await fromMenu(page, "Make a lesson");
  await expect(dialog.getByLabel("Title")).toHaveValue("Three");
});
