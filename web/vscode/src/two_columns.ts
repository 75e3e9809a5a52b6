// C beside what it becomes on the card, in a panel that follows the program in the editor. Its view is
// that of the page.
// Tested by test/package.test.ts and e2e/editor.spec.ts.

import { basename, resolve } from "node:path";

import { type Engine, RefusedError, type TwoColumns } from "@oncard/engine";
import { type Shown, shownAfter } from "@oncard/playground/two_columns/shown";
import {
  commands,
  type Disposable,
  Range,
  type TextDocument,
  type TextEditor,
  ThemeColor,
  Uri,
  type ViewColumn,
  type WebviewPanel,
  window,
  workspace,
} from "vscode";

import { oneAtATime } from "./asking";
import { mainOf, projectOf } from "./documents";
import type { Engines } from "./engines";
import { language, say } from "./texts";
import type { FromView, Place, ToView } from "./two_columns_messages";
import { openView } from "./views";

export function registerTwoColumns(engines: Engines): Disposable[] {
  let panel: TwoColumnsPanel | undefined;
  return [
    { dispose: () => panel?.close() },
    commands.registerCommand("oncard.showTwoColumns", () => {
      panel ??= new TwoColumnsPanel(engines, () => {
        panel = undefined;
      });
      panel.show();
    }),
  ];
}

class TwoColumnsPanel {
  readonly #engines: Engines;
  readonly #panel: WebviewPanel;
  /** It stays open: it is asked while the user types. */
  #engine: Promise<Engine> | undefined;
  #document: TextDocument | undefined;
  /** Where its editor is. */
  #column: ViewColumn | undefined;
  #shown: Shown | undefined;
  #chosen: Place | undefined;
  readonly #pointed = window.createTextEditorDecorationType({
    backgroundColor: new ThemeColor("editor.hoverHighlightBackground"),
    isWholeLine: true,
  });
  readonly #ask = oneAtATime(() => this.#askOnce());

  constructor(engines: Engines, onClosed: () => void) {
    this.#engines = engines;
    const title = say({ en: "C beside card code", zh: "C 与卡代码" });
    this.#panel = openView(engines.viewFolder, "two_columns", title);
    const watched = [
      window.onDidChangeActiveTextEditor((editor) => {
        this.#follow(editor);
      }),
      window.onDidChangeTextEditorSelection(({ textEditor }) => {
        if (textEditor.document === this.#document) this.#choose(textEditor);
      }),
      // A program may include any file that is open.
      workspace.onDidChangeTextDocument(({ document }) => {
        if (document.uri.scheme === "file") this.#ask();
      }),
      this.#panel.webview.onDidReceiveMessage((message: FromView) => {
        if (message === "ready") this.#send();
        else if ("point" in message) this.#mark(message.point);
        else void this.#showLine(message.show);
      }),
    ];
    this.#panel.onDidDispose(() => {
      for (const each of watched) each.dispose();
      this.#pointed.dispose();
      this.#document = undefined;
      this.#closeEngine();
      onClosed();
    });
    this.#follow(window.activeTextEditor);
  }

  show(): void {
    this.#panel.reveal(undefined, true);
  }

  close(): void {
    this.#panel.dispose();
  }

  #follow(editor: TextEditor | undefined): void {
    if (!editor || !isProgram(editor.document)) return;
    this.#document = editor.document;
    this.#column = editor.viewColumn;
    const name = basename(editor.document.uri.fsPath);
    this.#panel.title = say({ en: `${name} beside card code`, zh: `${name} 与卡代码` });
    this.#ask();
    this.#choose(editor);
  }

  #choose({ document, selection }: TextEditor): void {
    this.#chosen = { file: projectOf(document).main, line: selection.active.line + 1 };
    this.#post({ chosen: this.#chosen });
  }

  async #askOnce(): Promise<void> {
    const document = this.#document;
    if (!document) return;
    const answer = await this.#answerAbout(document);
    this.#shown = shownAfter(this.#shown, document.uri.toString(), answer);
    this.#send();
  }

  /** Nothing if there is none. */
  async #answerAbout(document: TextDocument): Promise<TwoColumns | undefined> {
    // The module, also if there is a command: that may be older than the view.
    const opened = (this.#engine ??= this.#engines.openModule());
    try {
      const { files } = projectOf(document);
      return await (await opened).twoColumns({ main: await mainOf(document), files });
    } catch (error) {
      if (!(error instanceof RefusedError) && this.#engine === opened) this.#closeEngine();
      return undefined;
    }
  }

  #closeEngine(): void {
    this.#engine?.then(
      (engine) => {
        engine.close();
      },
      () => undefined, // it did not start
    );
    this.#engine = undefined;
  }

  #send(): void {
    if (!this.#shown || !this.#document) return;
    this.#post({
      shown: this.#shown,
      language: language(),
      ...(this.#chosen && { chosen: this.#chosen }),
    });
  }

  #post(message: ToView): void {
    void this.#panel.webview.postMessage(message);
  }

  /** Marks the line of C whose statements the pointer is at. */
  #mark(place: Place | null): void {
    const path = place && resolve(place.file);
    for (const editor of window.visibleTextEditors) {
      const isIn = editor.document.uri.fsPath === path;
      const lines = place && isIn ? [new Range(place.line - 1, 0, place.line - 1, 0)] : [];
      editor.setDecorations(this.#pointed, lines);
    }
  }

  async #showLine({ file, line }: Place): Promise<void> {
    const selection = new Range(line - 1, 0, line - 1, 0);
    const options = { selection, ...(this.#column && { viewColumn: this.#column }) };
    await window.showTextDocument(Uri.file(resolve(file)), options);
  }
}

function isProgram({ uri, languageId }: TextDocument): boolean {
  return uri.scheme === "file" && (languageId === "c" || languageId === "motion-program");
}
