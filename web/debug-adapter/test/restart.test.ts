import { writeFileSync } from "node:fs";

import type { DebugProtocol } from "@vscode/debugprotocol";
import { expect, test } from "vitest";

import { openEditor, programOf } from "./support.js";

const program = "int x;\nint f()\n{\n  x = 1;\n  x = 2;\n  return x;\n}\n";
const endless = "int x;\nint f()\n{\nagain:\n  x = x + 1;\n  goto again;\n}\n";

test("the program begins again", async () => {
  const editor = await openEditor();
  await editor.enter(programOf(program));
  await editor.move("next");
  await editor.move("next");
  expect(await editor.value("x")).toBe("1");
  await editor.request("restart");
  expect(await editor.stopped()).toMatchObject({ reason: "entry" });
  expect([await editor.line(), await editor.value("x")]).toEqual([4, "0"]);
});

test("breakpoints stay, and are found again in an edited program", async () => {
  const path = programOf(program);
  const editor = await openEditor();
  await editor.launch(path);
  const [line] = await editor.breakpoints(path, [{ line: 5 }]);
  const { breakpoints } = await editor.request<{ breakpoints: DebugProtocol.Breakpoint[] }>(
    "setFunctionBreakpoints",
    { breakpoints: [{ name: "f" }, { name: "g" }] },
  );
  const [beginning, missing] = breakpoints;
  expect(await editor.run()).toMatchObject({ hitBreakpointIds: [beginning?.id] });

  const changed: DebugProtocol.Breakpoint[] = [];
  editor.client.on("breakpoint", ({ body }: DebugProtocol.BreakpointEvent) => {
    changed.push(body.breakpoint);
  });
  writeFileSync(path, "int x;\nint g()\n{\n\n\n\n  x = 7;\n  return x;\n}\n");
  await editor.request("restart");
  expect(await editor.stopped()).toMatchObject({ reason: "breakpoint" });
  expect([await editor.line(), await editor.value("x")]).toEqual([7, "0"]);
  expect(changed).toEqual([
    { id: line?.id, verified: true, line: 7 },
    { id: beginning?.id, verified: false, message: "there is no function 'f'" },
    { id: missing?.id, verified: true, line: 7 },
  ]);
});

test("a running card stops for it, and the old one says nothing more", async () => {
  const path = programOf(endless);
  const editor = await openEditor();
  await editor.launch(path);
  await editor.client.configurationDoneRequest();
  writeFileSync(path, program);
  await editor.request("restart");
  expect(await editor.stopped()).toMatchObject({ text: /every thread has ended/ });
  expect(await editor.value("x")).toBe("2");
});

test("a program that cannot be launched leaves the card as it is", async () => {
  const path = programOf(program);
  const editor = await openEditor();
  await editor.enter(path);
  await editor.move("next");
  await editor.move("next");
  writeFileSync(path, "int f()\n{\n  y = 1;\n}\n");
  await expect(editor.request("restart")).rejects.toThrow("'y' is not declared");
  expect([await editor.line(), await editor.value("x")]).toEqual([5, "1"]);
  await editor.move("next");
  expect(await editor.value("x")).toBe("2");
});

test("a launch configuration that has changed counts", async () => {
  const editor = await openEditor();
  await editor.enter(programOf(program));
  const other = programOf("int y;\nint f()\n{\n  y = 3;\n}\n");
  await editor.request("restart", { arguments: { program: other, stopOnEntry: true } });
  expect(await editor.stopped()).toMatchObject({ reason: "entry" });
  expect(await editor.value("y")).toBe("0");
});
