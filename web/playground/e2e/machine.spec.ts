// The machine: how a scenario wants it to look.

import { expect, type Page, test } from "@playwright/test";

import { expectAccessible, open, openOwn, runToEnd, status, write } from "./support.js";

/** One's own program with this view. */
async function load(page: Page, view: string): Promise<void> {
  await open(page);
  await openOwn(page);
  await page.getByRole("button", { name: "scenario.toml" }).click();
  await write(page, `program = "program.c"\n[view]\n${view}`);
  await expect(status(page)).toHaveText("Card ready.");
}

test("a machine that names its pins shows only these at first", async ({ page }) => {
  await load(
    page,
    'title = "Drill"\n[[view.pin]]\ntype = "gpo"\nindex = 2\nname = "Spindle"\n' +
      '[[view.pin]]\nindex = 3\nname = "Door"\n',
  );
  const machine = page.locator("#machine");
  await expect(machine).toContainText("Drill");
  await expect(machine.getByRole("img", { name: "Spindle: off" })).toContainText("DO 2");
  await expect(machine.getByRole("button", { name: "Input gpi 1", exact: true })).toBeHidden();
  const door = machine.getByRole("switch", { name: "Door" });
  await expect(door).toHaveAttribute("aria-checked", "false");
  await door.click();
  await runToEnd(page); // the level passes the card's filter
  await expect(door).toHaveAttribute("aria-checked", "true");
  await machine.getByText("all inputs and outputs").click();
  await expect(machine.getByRole("button", { name: "Input gpi 3" })).toHaveAttribute(
    "aria-pressed",
    "true",
  );
  await expectAccessible(page);
});

// The program moves axis 1 to 50 000 pulses.
for (const [kind, turn, seen] of [
  ["rotary", 40_000, "text=90°"],
  ["conveyor", 10_000, ".belt"],
  ["gripper", 10_000, ".jaws.open"],
] as const) {
  test(`a machine of the kind ${kind}`, async ({ page }) => {
    await load(page, `kind = "${kind}"\nturn = ${turn}\n`);
    await runToEnd(page);
    await expect(page.locator('output[data-axis="1"]')).toHaveText("50000 pulse");
    await expect(page.locator("#machine").locator(seen)).toBeVisible();
    await expect(page.getByRole("img", { name: /^XY table/ })).toHaveCount(0);
  });
}

test("a table has the scale of its longer axis, and Z beside it", async ({ page }) => {
  await load(page, 'kind = "xy"\nx = 1\ny = 3\nz = 4\n');
  await runToEnd(page);
  const table = page.getByRole("img", { name: "XY table at 50000 pulse, 0 pulse, 0 pulse" });
  await expect(table).toBeVisible();
  // Both scales end at 50 000.
  await expect(table.getByText("50000", { exact: true })).toHaveCount(1);
  await expect(table.getByText("50k", { exact: true })).toHaveCount(1);
  await expect(table.getByText("Z", { exact: true })).toHaveCount(1);
});
