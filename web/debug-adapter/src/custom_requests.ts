// What an editor asks beyond the protocol: the machine, and what stands behind the lines of a program.
// docs/debugger.md describes it.
// Tested by test/custom_requests.test.ts.

import { InvalidatedEvent } from "@vscode/debugadapter";

import type { Editor } from "./editor.js";
import type { Launched } from "./launched.js";

interface TraceArguments {
  names: string[];
  from_ms: number;
  to_ms: number;
  points: number;
}

interface SetInputArguments {
  type: string;
  index: number;
  level: number;
}

/** The engine says what is wrong with the arguments. */
type Answer<Arguments> = (launched: Launched, args: Arguments, editor: Editor) => Promise<object>;

const card: Answer<unknown> = async ({ engine }) => ({
  card: await engine.card(),
  state: await engine.state(),
});

const trace: Answer<TraceArguments> = async ({ engine }, { names, from_ms, to_ms, points }) => ({
  channels: await engine.trace(names, from_ms, to_ms, points),
});

/** The variables of the editor show inputs, too. */
const setInput: Answer<SetInputArguments> = async (launched, { type, index, level }, editor) => {
  launched.state = await launched.engine.setInput(type, index, level);
  launched.variables.forgetValues();
  if (editor.takesInvalidated) editor.tell(new InvalidatedEvent(["variables"]));
  return {};
};

/** The lines with the paths of their files. */
const written: Answer<unknown> = async ({ engine, code, state }) => ({
  lines: (await engine.written()).map((line) => ({ ...line, path: code.source(line.file)?.path })),
  moment: state.moment,
});

/** By the names of the requests. */
export const customRequests: ReadonlyMap<string, Answer<never>> = new Map<string, Answer<never>>([
  ["oncard.card", card],
  ["oncard.trace", trace],
  ["oncard.setInput", setInput],
  ["oncard.written", written],
]);
