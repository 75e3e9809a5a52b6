// What stands behind the lines of the program.

import { expect, type Page, test } from "@playwright/test";

import { editor, expectAccessible, open, openOwn, runToEnd, write } from "./support.js";

const program = `int x;
int main()
{
  x = 7 * 1;
  x = x * 6;
  GT_SetVel(1, 20);
  return x;
}
`;

async function behind(page: Page, kind: string): Promise<(string | null)[]> {
  const all = await page.locator(kind).all();
  return Promise.all(all.map((each) => each.getAttribute("data-text")));
}

async function openProgram(page: Page): Promise<void> {
  await open(page);
  await openOwn(page);
  await write(page, program);
  await expect(page.getByText("No messages")).toBeVisible();
}

test("values stand behind the lines that made them, at the present moment", async ({ page }) => {
  await openProgram(page);
  await expect(page.locator(".cm-made")).toHaveCount(0);
  await runToEnd(page);
  await expect.poll(() => behind(page, ".cm-made")).toEqual(["x = 7", "x = 42", "→ 42"]);
  await expect(page.locator(".cm-made.t0")).toHaveCount(3);
  await expectAccessible(page);
  const back = page.getByRole("button", { name: "Step back" });
  await back.click();
  await expect.poll(() => behind(page, ".cm-made")).toEqual(["x = 7", "x = 42"]);
  await back.click();
  await expect.poll(() => behind(page, ".cm-made-now")).toEqual(["x = 42"]);
  await back.click();
  await expect.poll(() => behind(page, ".cm-made-now")).toEqual(["x = 7"]);
});

test("values go with an edit: they are of another text", async ({ page }) => {
  await openProgram(page);
  await runToEnd(page);
  await expect(page.locator(".cm-made")).toHaveCount(3);
  await editor(page).getByText("return x;").click();
  await page.keyboard.press("End");
  await page.keyboard.type(" // here");
  await expect(page.locator(".cm-made")).toHaveCount(0);
});

test("units stand behind arguments and members of structures, and go with their lines", async ({
  page,
}) => {
  await openProgram(page);
  await expect.poll(() => behind(page, ".cm-unit")).toEqual(["pulse/ms"]);
  await write(page, program.replace("GT_SetVel(1, 20)", "GT_SetPos(1, 20)"));
  await expect.poll(() => behind(page, ".cm-unit")).toEqual(["pulse"]);
  await write(page, "TTrapPrm trap;\nint main()\n{\n  trap.acc = 0.25;\n  return 0;\n}\n");
  await expect.poll(() => behind(page, ".cm-unit")).toEqual(["pulse/ms^2"]);
});
