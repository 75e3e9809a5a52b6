import type { DebugProtocol } from "@vscode/debugprotocol";
import { expect, test } from "vitest";

import { type Editor, openEditor, programOf, unpowered } from "./support.js";

const driveOff = "p.c:6: warning: axis 1 moves while its drive is off, call GT_AxisOn first";

/** The outputs that are warnings. */
function warningsOf(editor: Editor): DebugProtocol.OutputEvent["body"][] {
  const outputs: DebugProtocol.OutputEvent["body"][] = [];
  editor.client.on("output", ({ body }: DebugProtocol.OutputEvent) => {
    if (body.output.includes("warning: ")) outputs.push(body);
  });
  return outputs;
}

/** Runs the program to its end. */
async function run(config: Record<string, unknown> = {}) {
  const editor = await openEditor();
  const warnings = warningsOf(editor);
  const path = programOf(unpowered);
  await editor.launch(path, config);
  const { reason } = await editor.run();
  return { editor, warnings, path, reason };
}

test("a warning is written with its place, without a stop", async () => {
  const { warnings, path, reason } = await run();
  expect(reason).toBe("pause");
  expect(warnings).toMatchObject([
    { category: "console", output: `${driveOff} [drive-off]\n`, source: { path }, line: 6 },
    { category: "console", source: { path }, line: 6 },
  ]);
  expect(warnings[1]?.output).toMatch(/^p\.c:6: warning: axis 1 still moves .* \[work-left\]\n$/);
});

test("going back and forward again does not repeat it", async () => {
  const { editor, warnings } = await run();
  await editor.move("reverseContinue");
  await editor.move("continue");
  expect(warnings).toHaveLength(2);
});

test("a restart begins anew", async () => {
  const { editor, warnings } = await run();
  await editor.request("restart");
  await editor.stopped();
  expect(warnings).toHaveLength(4);
});

test("a stop at a warning names it, and it is written once", async () => {
  const editor = await openEditor();
  await editor.launch(programOf(unpowered));
  await editor.request("setExceptionBreakpoints", { filters: ["warning"] });
  const { reason, threadId, text } = await editor.run();
  expect({ reason, threadId }).toEqual({ reason: "exception", threadId: 1 });
  expect(text).toMatch(
    /^a warning of the card: .*p\.c:6: thread 0 f: axis 1 moves .* \[drive-off\]$/,
  );
  expect(editor.output).toBe(`${driveOff} [drive-off]\n`);
});

test("those that are not wanted are left out", async () => {
  const { warnings } = await run({ silent: ["drive-off"] });
  expect(warnings).toHaveLength(1);
  expect(warnings[0]?.output).toContain("[work-left]");
});

test("one that does not exist cannot be left out", async () => {
  const editor = await openEditor();
  const launched = editor.launch(programOf(unpowered), { silent: ["drive-on"] });
  await expect(launched).rejects.toThrow("there is no 'drive-on'");
});

test("in the editor's language", async () => {
  const editor = await openEditor();
  await editor.initialize({ locale: "zh-cn" });
  await Promise.all([
    editor.client.waitForEvent("initialized"),
    editor.request("launch", { program: programOf(unpowered) }),
  ]);
  await editor.run();
  expect(editor.output).toContain(
    "p.c:6: 警告：轴 1 在伺服使能关闭时运动，请先调用 GT_AxisOn [drive-off]\n",
  );
});
