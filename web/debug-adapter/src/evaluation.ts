// Expressions of the editor: evaluated where a thread stands, and changed.
// Tested by test/variables.test.ts.

import type { Evaluation } from "@oncard/engine";
import type { DebugProtocol } from "@vscode/debugprotocol";

import { hostThread } from "./host.js";
import { type Launched, threadOf } from "./launched.js";
import { numberOf } from "./variables.js";

/** An expression's value, and the engine's name for it if it has one. */
export interface Evaluated {
  evaluation: Evaluation;
  path: string | undefined;
}

/** Names are first looked for among the locals of the frame. */
export async function evaluateAt(
  launched: Launched,
  text: string,
  frameId?: number,
): Promise<Evaluated> {
  const found = frameId === undefined ? undefined : threadOf(launched, frameId).thread;
  const thread = found === hostThread ? undefined : found;
  const evaluation = await launched.engine.evaluate(text, thread);
  return { evaluation, path: "path" in evaluation ? evaluation.path : undefined };
}

/** What the editor shows of an expression. */
export async function evaluate(
  launched: Launched,
  { expression, frameId }: DebugProtocol.EvaluateArguments,
): Promise<DebugProtocol.EvaluateResponse["body"]> {
  const { evaluation, path } = await evaluateAt(launched, expression, frameId);
  if (path === undefined || !("value" in evaluation)) {
    return { result: shown(evaluation), variablesReference: 0 };
  }
  const { value, ...rest } = launched.variables.shown(path, evaluation.value);
  return { result: value, ...rest };
}

/** Changes what an expression names; gives its new value. */
export async function setExpression(
  launched: Launched,
  { expression, value, frameId }: DebugProtocol.SetExpressionArguments,
): Promise<string> {
  const path = (await evaluateAt(launched, expression, frameId)).path ?? expression;
  launched.state = await launched.engine.write(path, numberOf(value));
  launched.variables.forgetValues();
  return shown(await launched.engine.evaluate(path));
}

/** Changes a child of what was opened in the tree of variables; gives its new value. */
export async function setVariable(
  launched: Launched,
  { variablesReference, name, value }: DebugProtocol.SetVariableArguments,
): Promise<string> {
  const now = await launched.variables.set(variablesReference, name, value);
  launched.state = await launched.engine.state();
  return now;
}

function shown(evaluation: Evaluation): string {
  return String("value" in evaluation ? evaluation.value : evaluation.holds);
}
