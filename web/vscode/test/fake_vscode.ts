// The part of the module `vscode` that the extension uses, as far as its tests look: what is
// registered is kept, and what the user would answer is said beforehand. The data types are those of
// jest-mock-vscode.

import { readFileSync } from "node:fs";
import { readFile } from "node:fs/promises";

import { createVSCodeMock } from "jest-mock-vscode";
import { vi } from "vitest";

// Its types are those of jest's functions.
const data = createVSCodeMock(vi as never);
export const { CodeLens, EventEmitter, Location, ProgressLocation, Range, TaskScope } = data;
export const { ThemeColor, Uri, ViewColumn } = data;
type Uri = ReturnType<typeof Uri.file>;

export interface FakeDocument {
  uri: Uri;
  languageId: string;
  isDirty: boolean;
  getText(): string;
  save(): Promise<boolean>;
}

/** A file on disk as an open document. */
export function documentAt(path: string, languageId = "c"): FakeDocument {
  const text = readFileSync(path, "utf8");
  return {
    uri: Uri.file(path),
    languageId,
    isDirty: false,
    getText: () => text,
    save: () => Promise.resolve(true),
  };
}

type Handler = (...args: unknown[]) => unknown;
const nothing = { dispose: () => undefined };

/** What the extension has done, and what the user does. */
export const editor = {
  settings: {} as Record<string, unknown>,
  commands: new Map<string, Handler>(),
  providers: new Map<string, unknown>(),
  /** What was shown: messages, output, documents. */
  shown: [] as string[],
  /** What the user answers to the next questions. */
  answers: [] as unknown[],
  launched: [] as Record<string, unknown>[],
  controllers: [] as FakeController[],
  panels: [] as FakePanel[],
  /** Requests to the debugger, and its answers. */
  requests: [] as unknown[],
  debugAnswers: {} as Record<string, unknown>,

  reset(): void {
    Object.assign(editor, { settings: {}, shown: [], answers: [], launched: [], requests: [] });
    Object.assign(editor, { debugAnswers: {}, controllers: [], panels: [] });
    editor.commands.clear();
    editor.providers.clear();
    workspace.textDocuments = [];
    workspace.files = [];
    window.activeTextEditor = undefined;
    window.visibleTextEditors = [];
    debug.activeDebugSession = undefined;
    env.language = "en";
  },
};

function provide(kind: string, provider: unknown): typeof nothing {
  editor.providers.set(kind, provider);
  return nothing;
}

export const env = { language: "en" };

export const commands = {
  registerCommand(name: string, handler: Handler) {
    if (editor.commands.has(name)) throw new Error(`${name} is registered twice`);
    editor.commands.set(name, handler);
    return nothing;
  },
  executeCommand: (name: string) => Promise.resolve(editor.shown.push(name)),
};

export const languages = {
  registerCodeLensProvider: (_: unknown, provider: unknown) => provide("lenses", provider),
  registerInlineValuesProvider: (_: unknown, provider: unknown) =>
    provide("inline values", provider),
};

export const workspace = {
  textDocuments: [] as FakeDocument[],
  workspaceFolders: undefined,
  files: [] as Uri[],
  fs: { readFile: ({ fsPath }: Uri) => readFile(fsPath) },
  getConfiguration: (section: string) => ({
    get: (name: string) => editor.settings[`${section}.${name}`],
  }),
  asRelativePath: (uri: Uri | string) =>
    (typeof uri === "string" ? uri : uri.fsPath).replace(/.*\//, ""),
  findFiles: () => Promise.resolve(workspace.files),
  openTextDocument: (uri: Uri) => Promise.resolve(documentOf(uri)),
  onDidSaveTextDocument: () => nothing,
  changed: new EventEmitter<{ document: FakeDocument }>(),
  onDidChangeTextDocument: (listener: Handler) => workspace.changed.event(listener),
  registerTextDocumentContentProvider: (scheme: string, provider: unknown) =>
    provide(scheme, provider),
  createFileSystemWatcher: () => {
    const watcher = { ...nothing, onDidCreate: ignore, onDidChange: ignore, onDidDelete: ignore };
    return watcher;
  },
};

function ignore(): typeof nothing {
  return nothing;
}

function documentOf(uri: Uri): unknown {
  return uri.scheme === "file" ? documentAt(uri.fsPath) : { uri };
}

const ask = (text: string) => {
  editor.shown.push(text);
  return Promise.resolve(editor.answers.shift());
};

interface FakeEditor {
  document: FakeDocument;
  viewColumn?: number;
  selection?: { active: { line: number } };
  setDecorations?: Handler;
}

/** What a panel shows is a page in the real editor; here a test is its reader. */
export class FakePanel {
  readonly received = new EventEmitter<unknown>();
  readonly #closed = new EventEmitter<undefined>();
  readonly sent: unknown[] = [];
  readonly onDidDispose = this.#closed.event;
  readonly webview = {
    html: "",
    cspSource: "https://editor",
    asWebviewUri: ({ path }: Uri) => Uri.parse(`https://editor${path}`),
    onDidReceiveMessage: this.received.event,
    postMessage: (message: unknown) => Promise.resolve(this.sent.push(message)),
  };
  constructor(public title: string) {}
  reveal(): void {
    editor.shown.push(this.title);
  }
  dispose(): void {
    this.#closed.fire(undefined);
  }
}

export const window = {
  activeTextEditor: undefined as FakeEditor | undefined,
  visibleTextEditors: [] as FakeEditor[],
  createTextEditorDecorationType: () => nothing,
  followed: new EventEmitter<FakeEditor | undefined>(),
  onDidChangeActiveTextEditor: (listener: Handler) => window.followed.event(listener),
  selected: new EventEmitter<{ textEditor: FakeEditor }>(),
  onDidChangeTextEditorSelection: (listener: Handler) => window.selected.event(listener),
  createWebviewPanel: (_: string, title: string) => {
    const panel = new FakePanel(title);
    editor.panels.push(panel);
    return panel;
  },
  createOutputChannel: () => ({
    ...nothing,
    clear: () => undefined,
    show: () => undefined,
    appendLine: (line: string) => editor.shown.push(line),
  }),
  showErrorMessage: ask,
  showWarningMessage: ask,
  showInformationMessage: ask,
  showInputBox: ({ prompt }: { prompt: string }) => ask(prompt),
  showQuickPick: (items: { label: string }[]) => ask(items.map(({ label }) => label).join()),
  showTextDocument: (what: Uri | { uri: Uri }, options?: { selection?: { start: unknown } }) => {
    editor.shown.push(("uri" in what ? what.uri : what).toString());
    if (options?.selection) editor.shown.push(JSON.stringify(options.selection.start));
    return Promise.resolve();
  },
  withProgress: (_: unknown, work: Handler) =>
    work({}, { isCancellationRequested: false, onCancellationRequested: () => nothing }),
};

export class InlineValueText {
  constructor(
    readonly range: unknown,
    readonly text: string,
  ) {}
}

export class DebugAdapterExecutable {
  constructor(
    readonly command: string,
    readonly args: string[],
    readonly options: { env: Record<string, string> },
  ) {}
}

export const debug = {
  activeDebugSession: undefined as unknown,
  registerDebugAdapterDescriptorFactory: (_: string, factory: unknown) =>
    provide("adapter", factory),
  registerDebugAdapterTrackerFactory: (_: string, factory: unknown) => provide("tracker", factory),
  registerDebugConfigurationProvider: (_: string, provider: unknown) => provide("launch", provider),
  startDebugging: (_: unknown, config: Record<string, unknown>) => {
    editor.launched.push(config);
    return Promise.resolve(true);
  },
};

/** A debug session that answers with what a test says. */
export const session = {
  type: "oncard",
  customRequest: (command: string, args?: unknown) => {
    editor.requests.push(args === undefined ? command : { command, args });
    const answer = editor.debugAnswers[command];
    return answer instanceof Error ? Promise.reject(answer) : Promise.resolve(answer);
  },
};

export const tasks = {
  registerTaskProvider: (_: string, provider: unknown) => provide("tasks", provider),
};

export class Task {
  constructor(
    readonly definition: unknown,
    readonly scope: unknown,
    readonly name: string,
    readonly source: string,
    readonly execution: unknown,
    readonly problemMatchers: string[],
  ) {}
}
export class ProcessExecution {
  constructor(
    readonly process: string,
    readonly args: string[],
  ) {}
}
export class CustomExecution {
  constructor(readonly callback: () => Promise<unknown>) {}
}

export enum TestRunProfileKind {
  Run = 1,
  Debug = 2,
}
export class TestMessage {
  location: InstanceType<typeof Location> | undefined;
  constructor(readonly message: string) {}
}

interface FakeItem {
  id: string;
  label: string;
  uri: Uri;
}

export class FakeController {
  readonly items = {
    map: new Map<string, FakeItem>(),
    add: (item: FakeItem) => this.items.map.set(item.id, item),
    delete: (id: string) => this.items.map.delete(id),
    forEach: (work: (item: FakeItem) => void) => {
      this.items.map.forEach(work);
    },
  };
  readonly profiles = new Map<TestRunProfileKind, Handler>();
  /** What became of each scenario. */
  readonly results: Record<string, "passed" | TestMessage[]> = {};
  resolveHandler: Handler = () => undefined;

  createTestItem(id: string, label: string, uri: Uri): FakeItem {
    return { id, label, uri };
  }
  createRunProfile(_: string, kind: TestRunProfileKind, run: Handler): void {
    this.profiles.set(kind, run);
  }
  createTestRun() {
    return {
      started: () => undefined,
      passed: ({ label }: FakeItem) => (this.results[label] = "passed"),
      failed: ({ label }: FakeItem, messages: TestMessage[]) => (this.results[label] = messages),
      end: () => undefined,
    };
  }
}

export const tests = {
  createTestController: () => {
    const controller = new FakeController();
    editor.controllers.push(controller);
    return controller;
  },
};
