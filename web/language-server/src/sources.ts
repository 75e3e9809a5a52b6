// What the engine knows about the names of a program, in the terms of the protocol.
// Tested by test/sources.test.ts.

import type {
  Candidate,
  Engine,
  FileRange,
  OutlineEntry,
  SourcePlace,
  SourceProject,
  Word,
} from "@oncard/engine";
import {
  type CompletionItem,
  CompletionItemKind,
  type DocumentSymbol,
  type FoldingRange,
  FoldingRangeKind,
  type Hover,
  type InlayHint,
  InlayHintKind,
  type Location,
  MarkupKind,
  type Position,
  type Range,
  type SemanticTokens,
  SemanticTokensBuilder,
  type SignatureHelp,
  SymbolKind,
  type TextEdit,
  type WorkspaceEdit,
} from "vscode-languageserver";

import type { Documents } from "./documents.js";
import { beside, uriOf } from "./paths.js";
import { Lines } from "./positions.js";

/** The kinds of words of the engine, as the legend of the protocol has them. */
const tokenTypes = {
  command: "function",
  function: "function",
  "thread-function": "function",
  global: "variable",
  local: "variable",
  parameter: "parameter",
  label: "label",
  macro: "macro",
  "macro-parameter": "parameter",
  constant: "enumMember",
  enum: "enum",
  struct: "struct",
  typedef: "type",
  member: "property",
  number: "number",
  string: "string",
  comment: "comment",
  type: "type",
  keyword: "keyword",
  directive: "macro",
} as const satisfies Record<Word["kind"], string>;

/** Commands belong to the library, globals are static. */
const modifiers = ["declaration", "modification", "defaultLibrary", "static"] as const;

export const legend = {
  tokenTypes: [...new Set<string>(Object.values(tokenTypes))],
  tokenModifiers: [...modifiers],
};

const completionKinds: Record<Candidate["kind"], CompletionItemKind> = {
  command: CompletionItemKind.Function,
  function: CompletionItemKind.Function,
  global: CompletionItemKind.Variable,
  local: CompletionItemKind.Variable,
  parameter: CompletionItemKind.Variable,
  label: CompletionItemKind.Reference,
  macro: CompletionItemKind.Constant,
  "macro-parameter": CompletionItemKind.Variable,
  constant: CompletionItemKind.EnumMember,
  enum: CompletionItemKind.Enum,
  struct: CompletionItemKind.Struct,
  typedef: CompletionItemKind.Class,
  member: CompletionItemKind.Field,
  value: CompletionItemKind.Value,
  type: CompletionItemKind.Class,
  keyword: CompletionItemKind.Keyword,
  directive: CompletionItemKind.Keyword,
  key: CompletionItemKind.Property,
  table: CompletionItemKind.Module,
};

const symbolKinds: Record<OutlineEntry["kind"], SymbolKind> = {
  command: SymbolKind.Function,
  function: SymbolKind.Function,
  global: SymbolKind.Variable,
  local: SymbolKind.Variable,
  parameter: SymbolKind.Variable,
  label: SymbolKind.Key,
  macro: SymbolKind.Constant,
  "macro-parameter": SymbolKind.Variable,
  constant: SymbolKind.EnumMember,
  enum: SymbolKind.Enum,
  struct: SymbolKind.Struct,
  typedef: SymbolKind.Class,
  member: SymbolKind.Field,
};

/** A program in an engine: what the editor asks about its files. */
export class Source {
  readonly #documents: Documents;
  readonly #engine: Engine;
  readonly #path: string;
  readonly #project: SourceProject;
  readonly #lines = new Map<string, Lines>();

  private constructor(documents: Documents, engine: Engine, path: string, project: SourceProject) {
    this.#documents = documents;
    this.#engine = engine;
    this.#path = path;
    this.#project = project;
  }

  /** The program at a path, with the options of its scenario if that can be read. */
  static async open(documents: Documents, engine: Engine, path: string): Promise<Source> {
    const files = documents.openTexts();
    const alone = new Source(documents, engine, path, { main: path, files, file: path });
    const scenario = await documents.scenarioOf(path);
    if (scenario === undefined) return alone;
    const project = { main: scenario, files, file: path };
    try {
      await engine.outline(project);
    } catch {
      // The scenario has mistakes, which are shown in it.
      return alone;
    }
    return new Source(documents, engine, path, project);
  }

  async hover(position: Position): Promise<Hover | null> {
    const found = await this.#engine.describe(await this.#place(position));
    if (!found) return null;
    const contents = { kind: MarkupKind.Markdown, value: found.markdown };
    return { contents, range: await this.#range(found.range) };
  }

  async signatureHelp(position: Position): Promise<SignatureHelp | null> {
    const found = await this.#engine.signature(await this.#place(position));
    if (!found) return null;
    const parameters = found.parameters.map(({ label, note }) =>
      note === undefined ? { label } : { label, documentation: note },
    );
    const signature = { label: found.label, parameters };
    return {
      signatures: [
        found.brief === undefined ? signature : { ...signature, documentation: found.brief },
      ],
      activeSignature: 0,
      // Behind the last one: too many arguments.
      activeParameter: found.active ?? parameters.length,
    };
  }

  async completion(position: Position): Promise<CompletionItem[]> {
    const { range, items } = await this.#engine.complete(await this.#place(position));
    const replaced = await this.#range(range);
    return items.map(({ label, kind, detail, documentation, insert }, index) => ({
      label,
      kind: completionKinds[kind],
      textEdit: { range: replaced, newText: insert ?? label },
      filterText: label,
      // The most likely first, as the engine has them.
      sortText: String(index).padStart(5, "0"),
      ...(detail === undefined ? {} : { detail }),
      ...(documentation === undefined
        ? {}
        : { documentation: { kind: MarkupKind.Markdown, value: documentation } }),
    }));
  }

  async definition(position: Position): Promise<Location[]> {
    return this.#locations(await this.#engine.definition(await this.#place(position)));
  }

  async references(position: Position, declaration: boolean): Promise<Location[]> {
    const found = await this.#engine.references(await this.#place(position), declaration);
    return this.#locations(found);
  }

  /** The name that would be renamed; nothing if there is none that can be. */
  async renamed(position: Position): Promise<Range | null> {
    const place = await this.#place(position);
    const [first] = await this.#engine.definition(place);
    const found = first && (await this.#engine.describe(place));
    return found ? this.#range(found.range) : null;
  }

  /** @throws RefusedError if the program would mean something else */
  async rename(position: Position, name: string): Promise<WorkspaceEdit> {
    const changes: Record<string, TextEdit[]> = {};
    for (const edit of await this.#engine.rename(await this.#place(position), name)) {
      const { uri, range } = await this.#location(edit);
      (changes[uri] ??= []).push({ range, newText: edit.text });
    }
    return { changes };
  }

  async symbols(): Promise<DocumentSymbol[]> {
    return this.#symbols(await this.#engine.outline(this.#project));
  }

  async folds(): Promise<FoldingRange[]> {
    const folds = await this.#engine.folds(this.#project);
    return folds.map(({ kind, line, end_line }) => {
      const range = { startLine: line - 1, endLine: end_line - 1 };
      return kind === "comment" ? { ...range, kind: FoldingRangeKind.Comment } : range;
    });
  }

  async tokens(): Promise<SemanticTokens> {
    const builder = new SemanticTokensBuilder();
    const lines = await this.#linesOf(this.#path);
    for (const word of await this.#engine.tokens(this.#project)) {
      const { start, end } = lines.range(word);
      // A token of the protocol is in one line.
      if (start.line !== end.line) continue;
      const length = end.character - start.character;
      const type = legend.tokenTypes.indexOf(tokenTypes[word.kind]);
      builder.push(start.line, start.character, length, type, modifiersOf(word));
    }
    return builder.build();
  }

  async hints({ start, end }: Range): Promise<InlayHint[]> {
    const lines = await this.#linesOf(this.#path);
    const hints = await this.#engine.hints(this.#project);
    const shown: InlayHint[] = [];
    for (const hint of hints) {
      const position = lines.position(hint);
      if (position.line < start.line || position.line > end.line) continue;
      const shownHint: InlayHint = { position, label: hint.label };
      if (hint.kind !== "slot") {
        shownHint.kind = InlayHintKind.Parameter;
        shownHint.paddingRight = true;
      }
      shown.push(shownHint);
    }
    return shown;
  }

  // --- Places ------------------------------------------------------------------------------------

  async #place(position: Position): Promise<SourcePlace> {
    return { ...this.#project, ...(await this.#linesOf(this.#path)).place(position) };
  }

  async #range(range: FileRange): Promise<Range> {
    return (await this.#location(range)).range;
  }

  async #location(range: FileRange): Promise<Location> {
    const path = beside(this.#project.main, range.file);
    return { uri: uriOf(path), range: (await this.#linesOf(path)).range(range) };
  }

  #locations(ranges: readonly FileRange[]): Promise<Location[]> {
    return Promise.all(ranges.map((range) => this.#location(range)));
  }

  #symbols(entries: readonly OutlineEntry[]): Promise<DocumentSymbol[]> {
    return Promise.all(
      entries.map(async ({ kind, name, detail, range, name_range, children }) => ({
        name,
        detail,
        kind: symbolKinds[kind],
        range: await this.#range(range),
        selectionRange: await this.#range(name_range),
        children: await this.#symbols(children ?? []),
      })),
    );
  }

  async #linesOf(path: string): Promise<Lines> {
    const known = this.#lines.get(path);
    if (known) return known;
    const lines = new Lines((await this.#documents.text(path)) ?? "");
    this.#lines.set(path, lines);
    return lines;
  }
}

function modifiersOf({ kind, declaration, write }: Word): number {
  const has: Record<(typeof modifiers)[number], boolean> = {
    declaration: declaration ?? false,
    modification: write ?? false,
    defaultLibrary: kind === "command",
    static: kind === "global",
  };
  return modifiers.reduce((bits, name, index) => bits | (has[name] ? 1 << index : 0), 0);
}
