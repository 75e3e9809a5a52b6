import { spawnSync } from "node:child_process";
import { cpSync } from "node:fs";
import { join } from "node:path";

import { expect, test } from "vitest";

import { folderOf, named, oncard, openEditor, sample } from "./support.js";

/** A folder with copies of samples. */
function copiesOf(...names: string[]): string {
  const folder = folderOf({});
  for (const name of names) cpSync(sample(name), join(folder, name.replace(/.*\//, "")));
  return folder;
}

/** What `oncard` prints. It may fail: programs that fail are what one records. */
function run(folder: string, ...args: string[]): string {
  const { status, stdout } = spawnSync(oncard, args, { cwd: folder, encoding: "utf8" });
  expect([0, 1]).toContain(status);
  return stdout;
}

test("a recorded run takes the same turns", async () => {
  const folder = copiesOf("01_sum/sum.c", "01_sum/two_threads.toml");
  const options = ["--schedule", "random:7", "--record", "a.schedule", "--format=json"];
  const recorded = JSON.parse(run(folder, "run", "two_threads.toml", ...options)) as {
    state_hash: string;
  };
  const hashOf = async (main: string) => {
    const editor = await openEditor();
    await editor.launch(join(folder, main));
    expect(await editor.run()).toMatchObject({ text: /every thread has ended/ });
    return named(await editor.variables(await editor.scope("Card")), "hash").value;
  };
  expect(await hashOf("a.schedule")).toBe(recorded.state_hash);
  expect(await hashOf("two_threads.toml")).not.toBe(recorded.state_hash);
});

test("a counterexample is walked to its failure, and back to its cause", async () => {
  const folder = copiesOf("26_lost_update/sum.c", "26_lost_update/lost.toml");
  run(folder, "explore", "lost.toml", "--save", "lost.schedule");
  const editor = await openEditor();
  await editor.launch(join(folder, "lost.schedule"));
  expect(await editor.run()).toMatchObject({ text: /every thread has ended/ });
  expect(editor.output).toMatch(/^failed\nsum == 10: sum is 3$/m);
  // Thread 0 has overwritten what thread 1 wrote: 1 over 7.
  await editor.console("back change sum");
  await editor.stopped();
  await editor.console("back change sum");
  await editor.stopped();
  expect(await editor.value("sum")).toBe("7");
  expect(await editor.line(0)).toBe(16);
  await editor.console("thread 0");
  await editor.stopped();
  expect(await editor.value("sum")).toBe("1");
});

test("what the user has done is recorded and can be opened", async () => {
  const folder = copiesOf("26_lost_update/sum.c", "26_lost_update/lost.toml");
  const editor = await openEditor();
  await editor.enter(join(folder, "lost.toml"));
  while (await editor.ready(1)) {
    await editor.console("thread 1");
    await editor.stopped();
  }
  await editor.move("continue");
  await editor.console("record mine.schedule");
  const again = await openEditor();
  await again.launch(join(folder, "mine.schedule"));
  await again.run();
  expect(await again.value("sum")).toBe("10"); // 7 by the scenario's own policy
  expect(again.output).toMatch(/^passed$/m);
});
