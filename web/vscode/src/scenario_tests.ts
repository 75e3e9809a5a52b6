// Scenarios as tests, as `oncard test` has them: each is run by the engine, or explored if it says so,
// and what does not hold is shown at its line.
// Tested by test/scenario_tests.test.ts.

import type { Compiled, Engine } from "@oncard/engine";
import { RefusedError, type RunAnswer } from "@oncard/engine";
import { placedMistakes } from "@oncard/language-server/refusals";
import { isExplored, programOf } from "@oncard/language-server/documents";
import {
  type CancellationToken,
  type Disposable,
  Location,
  Range,
  type TestController,
  type TestItem,
  TestMessage,
  TestRunProfileKind,
  type TestRunRequest,
  tests,
  Uri,
  workspace,
} from "vscode";

import { startDebugging } from "./debug";
import type { Engines } from "./engines";
import { choiceLine, described, headline } from "./runs";
import { language, say } from "./texts";

const scenarios = "**/*.toml";

export function registerTests(engines: Engines): Disposable[] {
  const controller = tests.createTestController("oncard", say({ en: "scenarios", zh: "场景" }));
  controller.resolveHandler = async (item) => {
    if (!item) await findAll(controller);
  };
  controller.createRunProfile(
    say({ en: "Run", zh: "运行" }),
    TestRunProfileKind.Run,
    (request, token) => runAll(controller, engines, request, token),
    true,
  );
  controller.createRunProfile(
    say({ en: "Debug", zh: "调试" }),
    TestRunProfileKind.Debug,
    async (request) => {
      const [first] = wanted(controller, request);
      if (first?.uri) await startDebugging(first.uri.fsPath);
    },
    true,
  );
  const watcher = workspace.createFileSystemWatcher(scenarios);
  watcher.onDidCreate((uri) => refresh(controller, uri));
  watcher.onDidChange((uri) => refresh(controller, uri));
  watcher.onDidDelete((uri) => {
    controller.items.delete(uri.toString());
  });
  return [controller, watcher];
}

async function findAll(controller: TestController): Promise<void> {
  for (const uri of await workspace.findFiles(scenarios, "**/node_modules/**")) {
    await refresh(controller, uri);
  }
}

/** A file that names no program is no test. */
async function refresh(controller: TestController, uri: Uri): Promise<void> {
  const text = new TextDecoder().decode(await workspace.fs.readFile(uri));
  const id = uri.toString();
  if (programOf(text) === undefined) controller.items.delete(id);
  else controller.items.add(controller.createTestItem(id, workspace.asRelativePath(uri), uri));
}

function wanted(controller: TestController, { include, exclude }: TestRunRequest): TestItem[] {
  const all: TestItem[] = [];
  controller.items.forEach((item) => all.push(item));
  return (include ?? all).filter((item) => !(exclude ?? []).includes(item));
}

async function runAll(
  controller: TestController,
  engines: Engines,
  request: TestRunRequest,
  token: CancellationToken,
): Promise<void> {
  const run = controller.createTestRun(request);
  const engine = await engines.open();
  // Only the module explores; it is started for the first scenario that needs it.
  let explorer: Promise<Engine> | undefined;
  const judges = { engine, explorer: () => (explorer ??= engines.openModule()) };
  const close = () => {
    engine.close();
    explorer?.then(
      (started) => {
        started.close();
      },
      () => undefined, // said of the scenario that needed it
    );
  };
  // An endless run ends with its engine.
  token.onCancellationRequested(close);
  try {
    for (const item of wanted(controller, request)) {
      if (token.isCancellationRequested) break;
      run.started(item);
      const messages = await failuresOf(judges, item);
      if (messages.length === 0) run.passed(item);
      else run.failed(item, messages);
    }
  } finally {
    close();
    run.end();
  }
}

/** The engine for runs, and the one that explores. */
interface Judges {
  engine: Engine;
  explorer(): Promise<Engine>;
}

/** Nothing if the scenario is fulfilled. */
async function failuresOf(judges: Judges, item: TestItem): Promise<TestMessage[]> {
  const uri = item.uri;
  if (!uri) return [];
  try {
    const main = uri.fsPath.replaceAll("\\", "/");
    const text = new TextDecoder().decode(await workspace.fs.readFile(uri));
    if (isExplored(text)) return await failuresOfSearch(await judges.explorer(), main, uri, text);
    const answer = await judges.engine.run({ main });
    return answer.run?.passed ? [] : messagesOf(answer, uri, text);
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error);
    const placed = error instanceof RefusedError ? placedMistakes(why) : [];
    return placed.length === 0
      ? [placedMessage(why, uri, 1)]
      : placed.map(({ message, line }) => placedMessage(message, uri, line));
  }
}

/** Nothing if the verdict is the one that the scenario expects. */
async function failuresOfSearch(
  explorer: Engine,
  main: string,
  uri: Uri,
  scenario: string,
): Promise<TestMessage[]> {
  const answer = await explorer.explore({ main }, language());
  const { report, expected = "PROVED", text = "" } = answer;
  if (!report) return mistakesOf(answer);
  if (report.verdict === expected) return [];
  const what = say({ en: `the verdict should be ${expected}:`, zh: `结论应为 ${expected}：` });
  // There is one: it was asked for.
  const at = scenario.split("\n").findIndex((line) => /^[ \t]*\[?[ \t]*explore\b/.test(line));
  return [placedMessage(`${what}\n${text.trimEnd()}`, uri, at + 1)];
}

/** The errors of a program, at their places. */
function mistakesOf({ diagnostics }: Compiled): TestMessage[] {
  return diagnostics
    .filter(({ severity }) => severity === "error")
    .map((each) => placedMessage(headline(each), Uri.file(each.file), each.line));
}

function messagesOf(answer: RunAnswer, uri: Uri, scenario: string): TestMessage[] {
  if (!answer.run) return mistakesOf(answer);
  const { choice, failures } = answer.run;
  const messages = failures.map(({ expectation, message }) => {
    const said = expectation ? `${expectation}: ${message}` : message;
    const text = choice === undefined ? said : `${said}\n${choiceLine(choice)}`;
    return placedMessage(text, uri, lineOf(scenario, expectation));
  });
  return messages.length > 0
    ? messages
    : [placedMessage(described(answer).lines.join("\n"), uri, 1)];
}

/** The line of a scenario that has a text; the first one if none has. */
function lineOf(scenario: string, text: string): number {
  const found = scenario.split("\n").findIndex((line) => text !== "" && line.includes(text));
  return Math.max(0, found) + 1;
}

function placedMessage(text: string, uri: Uri, line: number): TestMessage {
  const message = new TestMessage(text);
  message.location = new Location(uri, new Range(line - 1, 0, line - 1, 0));
  return message;
}
