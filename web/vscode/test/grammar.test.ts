// The scopes of words, as the editor's own tokenizer finds them. scopes.txt is the expected text.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

import { expect, test } from "vitest";
import { loadWASM, OnigScanner, OnigString } from "vscode-oniguruma";
import { INITIAL, parseRawGrammar, Registry } from "vscode-textmate";

import { folder, manifest } from "./support.js";

const program = `//@ structured
//@ final: sum == 10
#include "constants.h"
#define LIMIT 0x64
/* a comment
   of two lines */
TTrapPrm trap;
double v = 1.5e3;

int move(int distance)
{
  GT_SetTrapPrm(1, &trap); // a command
again:
  distance = distance - 1;
  if (distance >= .5) goto again;
  while (v != 0) break;
  return distance;
}
`;

/** A little C, into which the words of motion programs are injected. */
const littleC = {
  scopeName: "source.c",
  patterns: [
    { name: "comment.block.c", begin: "/\\\\*", end: "\\\\*/" },
    { name: "variable.c", match: "\\\\w+" },
  ],
  repository: {},
};

async function registry(): Promise<Registry> {
  const oniguruma = createRequire(import.meta.url).resolve("vscode-oniguruma/release/onig.wasm");
  await loadWASM(readFileSync(oniguruma));
  const paths = new Map(
    manifest.contributes.grammars.map(({ scopeName, path }) => [scopeName, join(folder, path)]),
  );
  return new Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (patterns) => new OnigScanner(patterns),
      createOnigString: (text) => new OnigString(text),
    }),
    loadGrammar: (scope) => {
      const path = paths.get(scope);
      if (path === undefined) {
        return Promise.resolve(parseRawGrammar(JSON.stringify(littleC), "c.json"));
      }
      return Promise.resolve(parseRawGrammar(readFileSync(path, "utf8"), path));
    },
    getInjections: (scope) => (scope === "source.c" ? ["motion-program.in-c"] : undefined),
  });
}

const grammars = registry();

/** Each word with its innermost scope. */
async function scopesOf(scope: string, text: string): Promise<string> {
  const grammar = await (await grammars).loadGrammar(scope);
  if (!grammar) throw new Error(`there is no grammar ${scope}`);
  let stack = INITIAL;
  const rows: string[] = [];
  for (const line of text.trimEnd().split("\n")) {
    const { tokens, ruleStack } = grammar.tokenizeLine(line, stack);
    stack = ruleStack;
    rows.push(line);
    for (const { startIndex, endIndex, scopes } of tokens) {
      const word = line.slice(startIndex, endIndex);
      if (word.trim() !== "" && scopes.length > 1)
        rows.push(`    ${word} → ${scopes.at(-1) ?? ""}`);
    }
  }
  return `${rows.join("\n")}\n`;
}

test("a motion program", async () => {
  await expect(await scopesOf("source.motion-program", program)).toMatchFileSnapshot("scopes.txt");
});

test("in a C file, commands and requirements are marked, but not in comments", async () => {
  const scopes = await scopesOf("source.c", "GT_Update(1)\n//@ final: x\n/* GT_Stop */\n");
  expect(scopes).toContain("GT_Update → support.function.command.motion-program");
  expect(scopes).toContain("final → keyword.other.requirement.motion-program");
  expect(scopes).not.toContain("GT_Stop → support");
});
