// The sessions of this debugger: for panels that follow them, and what is asked of them.

import { debug, type DebugSession, type Disposable } from "vscode";

export interface Follower {
  began?(session: DebugSession): void;
  /** It stands elsewhere, or something of its card was changed. */
  moved(session: DebugSession): void;
  ended(session: DebugSession): void;
}

interface Message {
  type: string;
  event?: string;
  command?: string;
}

export function followSessions(followers: readonly Follower[]): Disposable {
  return debug.registerDebugAdapterTrackerFactory("oncard", {
    createDebugAdapterTracker: (session) => {
      for (const follower of followers) follower.began?.(session);
      return {
        onDidSendMessage: (message: Message) => {
          if (!isMove(message)) return;
          for (const follower of followers) follower.moved(session);
        },
        onWillStopSession: () => {
          for (const follower of followers) follower.ended(session);
        },
      };
    },
  });
}

function isMove({ type, event = "", command = "" }: Message): boolean {
  return type === "event"
    ? ["stopped", "invalidated"].includes(event)
    : ["setVariable", "setExpression"].includes(command);
}

/** A request that docs/debugger.md describes. */
export async function request<Answer>(
  session: DebugSession,
  command: string,
  args?: object,
): Promise<Answer> {
  return (await session.customRequest(command, args)) as Answer;
}
