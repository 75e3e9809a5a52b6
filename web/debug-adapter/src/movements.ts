// What moves the card: walks of the engine, and what the editor is told when they arrive.

import type { BackWalk, Engine, ForwardWalk, WalkOptions, WalkResult } from "@oncard/engine";

export interface Movement {
  walk: (engine: Engine, options: WalkOptions) => Promise<WalkResult>;
  /** The reason of the event if the walk arrives. */
  reason: string;
  /** The card's thread that the user moves. */
  thread?: number;
}

export const toNextStop: Movement = { ...forward({ goal: "stop" }), reason: "pause" };

export function forward(walk: ForwardWalk, thread?: number): Movement {
  return moving((engine, options) => engine.walkForward(walk, options), thread);
}

export function back(walk: BackWalk, thread?: number): Movement {
  return moving((engine, options) => engine.walkBack(walk, options), thread);
}

/** The next statement is one of this thread. */
export function turnOf(thread: number): Movement {
  return { walk: (engine) => engine.stepThread(thread), reason: "goto", thread };
}

function moving(walk: Movement["walk"], thread?: number): Movement {
  return thread === undefined ? { walk, reason: "step" } : { walk, reason: "step", thread };
}
