// The language server: requests of an editor in the Language Server Protocol, answered by an engine.
// It knows nothing about programs: it brings the documents to the engine, and converts positions.
// Tested by test/server.test.ts and test/transcript.test.ts.

import { type Engine, languageOf, RefusedError } from "@oncard/engine";
import {
  CodeActionKind,
  type CodeActionParams,
  type CodeAction,
  type Connection,
  type Diagnostic,
  ErrorCodes,
  type InitializeParams,
  type InitializeResult,
  type Position,
  type Range,
  ResponseError,
  type TextDocumentIdentifier,
  TextDocuments,
  TextDocumentSyncKind,
} from "vscode-languageserver";
import { TextDocument } from "vscode-languageserver-textdocument";

import { Checker, type Findings } from "./checker.js";
import { Diagnostics } from "./diagnostics.js";
import { Documents, type Kind } from "./documents.js";
import { fixAll, quickFixes } from "./fixes.js";
import { pathOf } from "./paths.js";
import { legend, Source } from "./sources.js";
import { wordsIn } from "./words.js";

const allKinds: readonly Kind[] = ["program", "scenario"];

/** Starts an engine. It is called again after one has ended. */
export type EngineOpener = () => Promise<Engine>;

export class LanguageServer {
  readonly #connection: Connection;
  readonly #openEngine: EngineOpener;
  readonly #editor = new TextDocuments(TextDocument);
  readonly #documents = new Documents(() => this.#editor.all());
  readonly #checker = new Checker(this.#documents);
  readonly #diagnostics: Diagnostics;
  #engine: Promise<Engine> | undefined;
  #language: "en" | "zh" = "en";
  /** Checks happen one after the other, as the engine answers. */
  #last: Promise<unknown> = Promise.resolve();

  constructor(connection: Connection, openEngine: EngineOpener) {
    this.#connection = connection;
    this.#openEngine = openEngine;
    this.#diagnostics = new Diagnostics(
      (uri) => this.#check(uri),
      (uri, diagnostics) => void connection.sendDiagnostics({ uri, diagnostics }),
    );
    connection.onInitialize((params) => this.#initialize(params));
    connection.onCodeAction((params) => this.#codeActions(params));
    this.#answerAboutSources();
    connection.onDidChangeWatchedFiles(() => {
      this.#checkAll();
    });
    connection.onShutdown(() => this.#close());
    this.#editor.onDidChangeContent(({ document }) => {
      this.#changed(document.uri);
    });
    this.#editor.onDidClose(({ document }) => {
      this.#diagnostics.closed(document.uri);
    });
    // Another program may include what was saved, or a scenario name it.
    this.#editor.onDidSave(() => {
      this.#checkAll();
    });
    this.#editor.listen(connection);
  }

  listen(): void {
    this.#connection.listen();
  }

  #initialize(params: InitializeParams): InitializeResult {
    this.#language = languageOf(params.locale);
    return {
      capabilities: {
        textDocumentSync: {
          openClose: true,
          change: TextDocumentSyncKind.Incremental,
          save: true,
        },
        hoverProvider: true,
        signatureHelpProvider: { triggerCharacters: ["(", ","] },
        completionProvider: { triggerCharacters: ["_", ".", "&", "#"] },
        definitionProvider: true,
        referencesProvider: true,
        renameProvider: { prepareProvider: true },
        documentSymbolProvider: true,
        foldingRangeProvider: true,
        semanticTokensProvider: { legend, full: true },
        inlayHintProvider: true,
        codeActionProvider: {
          codeActionKinds: [CodeActionKind.QuickFix, CodeActionKind.SourceFixAll],
        },
      },
      serverInfo: { name: "oncard" },
    };
  }

  async #close(): Promise<void> {
    (await this.#engine)?.close();
  }

  // --- The engine --------------------------------------------------------------------------------

  /** The engine; a new one if the last has ended. */
  #started(): Promise<Engine> {
    this.#engine ??= this.#start();
    return this.#engine;
  }

  async #start(): Promise<Engine> {
    const engine = await this.#openEngine();
    engine.supply = (path) => this.#documents.text(path);
    engine.onEnded = (why) => {
      this.#engine = undefined;
      this.#connection.console.warn(why.message);
    };
    await engine.hello(this.#language);
    return engine;
  }

  /** Work with the engine, after what was asked before. */
  #withEngine<Result>(work: (engine: Engine) => Promise<Result>): Promise<Result> {
    const result = this.#last.then(async () => work(await this.#started()));
    this.#last = result.catch(() => undefined);
    return result;
  }

  // --- Diagnostics -------------------------------------------------------------------------------

  /** A document has changed, and what other open documents say may have, too. */
  #changed(uri: string): void {
    for (const each of this.#editor.all()) {
      if (each.uri === uri || pathOf(uri).endsWith(".toml") || !pathOf(uri).endsWith(".c")) {
        this.#diagnostics.changed(each.uri);
      }
    }
  }

  #checkAll(): void {
    for (const { uri } of this.#editor.all()) this.#diagnostics.changed(uri);
  }

  async #check(uri: string): Promise<Findings | undefined> {
    const document = this.#editor.get(uri);
    const kind = document && (await this.#documents.kind(document));
    if (kind === undefined) return undefined;
    try {
      return await this.#withEngine((engine) => this.#checker.check(engine, pathOf(uri), kind));
    } catch (error) {
      this.#connection.console.error(error instanceof Error ? error.message : String(error));
      return undefined;
    }
  }

  // --- Names -------------------------------------------------------------------------------------

  #answerAboutSources(): void {
    const connection = this.#connection;
    connection.onHover((at) =>
      this.#about(at, null, (source) => source.hover(at.position), allKinds),
    );
    connection.onSignatureHelp((at) =>
      this.#about(at, null, (source) => source.signatureHelp(at.position)),
    );
    connection.onCompletion((at) =>
      this.#about(at, [], (source) => source.completion(at.position), allKinds),
    );
    connection.onDefinition((at) =>
      this.#about(at, [], (source) => source.definition(at.position)),
    );
    connection.onReferences((at) =>
      this.#about(at, [], (source) =>
        source.references(at.position, at.context.includeDeclaration),
      ),
    );
    connection.onPrepareRename((at) =>
      this.#about(at, null, (source) => source.renamed(at.position)),
    );
    connection.onRenameRequest((at) =>
      this.#about(at, null, (source) => source.rename(at.position, at.newName)),
    );
    connection.onDocumentSymbol((at) => this.#about(at, [], (source) => source.symbols()));
    connection.onFoldingRanges((at) => this.#about(at, [], (source) => source.folds()));
    connection.languages.semanticTokens.on((at) =>
      this.#about(at, { data: [] }, (source) => source.tokens()),
    );
    connection.languages.inlayHint.on((at) =>
      this.#about(at, [], (source) => source.hints(at.range)),
    );
  }

  /** Asks about a document of these kinds; others have the answer `nothing`. */
  async #about<Answer>(
    { textDocument }: { textDocument: TextDocumentIdentifier },
    nothing: Answer,
    ask: (source: Source, engine: Engine) => Promise<Answer>,
    kinds: readonly Kind[] = ["program"],
  ): Promise<Answer> {
    const document = this.#editor.get(textDocument.uri);
    const kind = document && (await this.#documents.kind(document));
    if (kind === undefined || !kinds.includes(kind)) return nothing;
    try {
      return await this.#withEngine(async (engine) =>
        ask(await Source.open(this.#documents, engine, pathOf(textDocument.uri)), engine),
      );
    } catch (error) {
      if (!(error instanceof RefusedError)) throw error;
      throw new ResponseError(ErrorCodes.InvalidRequest, error.message);
    }
  }

  // --- Corrections -------------------------------------------------------------------------------

  async #codeActions({ textDocument, range, context }: CodeActionParams): Promise<CodeAction[]> {
    const words = wordsIn(this.#language);
    const wanted = (kind: string) =>
      !context.only || context.only.some((only) => kind === only || kind.startsWith(`${only}.`));
    const path = pathOf(textDocument.uri);
    const here = this.#diagnostics
      .shown(textDocument.uri)
      .filter((each) => meets(each, range) || context.diagnostics.some((one) => same(one, each)));
    const quick = wanted(CodeActionKind.QuickFix)
      ? await quickFixes(this.#documents, path, here, words)
      : [];
    const all = wanted(CodeActionKind.SourceFixAll)
      ? await this.#about({ textDocument }, [], (_, engine) =>
          fixAll(this.#documents, engine, path, words),
        )
      : [];
    return [...quick, ...all];
  }
}

/** True if a diagnostic touches a range. */
function meets({ range }: Diagnostic, { start, end }: Range): boolean {
  return !isBefore(range.end, start) && !isBefore(end, range.start);
}

function same(a: Diagnostic, b: Diagnostic): boolean {
  return a.message === b.message && a.range.start.line === b.range.start.line;
}

function isBefore(a: Position, b: Position): boolean {
  return a.line < b.line || (a.line === b.line && a.character < b.character);
}
