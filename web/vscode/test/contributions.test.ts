import { readFileSync } from "node:fs";
import { join } from "node:path";

import { beforeEach, expect, test } from "vitest";

import { Engines } from "../src/engines";
import { registerFeatures } from "../src/features";
import { taskCommands } from "../src/tasks";
import { editor } from "./fake_vscode.js";
import { folder, manifest } from "./support.js";

const { contributes } = manifest;

beforeEach(() => {
  editor.reset();
});

const textOf = (file: string) => readFileSync(join(folder, file), "utf8");

test("what is contributed is registered, and nothing else", () => {
  registerFeatures(new Engines(folder));
  const contributed = contributes.commands.map(({ command }) => command);
  expect([...editor.commands.keys()].sort()).toEqual(contributed.sort());
  expect([...editor.providers.keys()].sort()).toEqual(
    ["adapter", "inline values", "launch", "lenses", "oncard-listing", "tasks", "tracker"].sort(),
  );
  expect(editor.controllers).toHaveLength(1);
});

test("menus name commands that exist", () => {
  const commands = contributes.commands.map(({ command }) => command);
  for (const entries of Object.values(contributes.menus)) {
    for (const { command } of entries) expect(commands).toContain(command);
  }
});

test("the tasks of the manifest are those that the provider knows", () => {
  const [definition] = contributes.taskDefinitions;
  expect(definition?.properties.command.enum).toEqual([...taskCommands]);
});

test("the settings are those that are read", () => {
  const sources = ["engines", "lenses"].map((name) => textOf(`src/${name}.ts`)).join();
  const read = [...sources.matchAll(/getConfiguration\("oncard"\)\.get<\w+>\("(\w+)"\)/g)];
  const names = read.map(([, name]) => `oncard.${name ?? ""}`);
  expect(Object.keys(contributes.configuration.properties).sort()).toEqual(names.sort());
});

/** The names of the rows between two headings of the debugger's page. */
function documented(from: string, to: string): string[] {
  const page = readFileSync(join(folder, "../../docs/debugger.md"), "utf8");
  const rows = page.split(from)[1]?.split(to)[0] ?? "";
  return [...rows.matchAll(/^\| `(\w+)` \|/gm)].map(([, name]) => name ?? "");
}

test("the launch attributes are those of the debugger's page", () => {
  const [oncard] = contributes.debuggers;
  const attributes = Object.keys(oncard?.configurationAttributes.launch.properties ?? {});
  expect(attributes.sort()).toEqual(documented("## Launching", "## Moving").sort());
});

test("those of attaching are the host's and some of a launch", () => {
  const [oncard] = contributes.debuggers;
  const attributes = Object.keys(oncard?.configurationAttributes.attach.properties ?? {});
  const ofLaunch = ["stopOnEntry", "stopAtFunction", "silent", "card", "oncard"];
  const ofHost = documented("## A host program", "## A counterexample");
  expect(ofHost).toContain("host");
  expect(attributes.sort()).toEqual([...ofHost, ...ofLaunch].sort());
});

test("both languages have the same texts, and all that are used", () => {
  const keys = (file: string) => Object.keys(JSON.parse(textOf(file)) as object).sort();
  const used = [...textOf("package.json").matchAll(/"%([\w.]+)%"/g)].map(([, name]) => name);
  expect(keys("package.nls.json")).toEqual([...new Set(used)].sort());
  expect(keys("package.nls.zh-cn.json")).toEqual(keys("package.nls.json"));
});
