// Values that are asked of the session for the panels. One question at a time: what has changed
// meanwhile is asked once, after the answer.

import { useEffect, useRef, useState } from "preact/hooks";

/** While the card runs, questions take at most one part in so many of the time. */
const share = 3;

/**
 * The last answer to a question that is asked again when its key changes.
 * @param key everything that the answer depends on
 * @param ask a failure keeps the answer before
 */
export function useAsked<Value>(
  key: string,
  ask: () => Promise<Value>,
  running: boolean,
): Value | undefined {
  const [value, setValue] = useState<Value>();
  const memory = useRef({ wanted: "", busy: false, gone: false, running, ask });
  memory.current.ask = ask;
  memory.current.running = running;
  useEffect(() => {
    const now = memory.current;
    now.wanted = key;
    if (now.busy) return;
    now.busy = true;
    void (async () => {
      let asked: string;
      do {
        asked = now.wanted;
        const begin = performance.now();
        try {
          const answer = await now.ask();
          if (!now.gone) setValue(() => answer);
        } catch {
          // The session was replaced or has ended; the status line says so.
        }
        const took = performance.now() - begin;
        if (now.running) await new Promise((resume) => setTimeout(resume, took * share));
      } while (!now.gone && asked !== now.wanted);
      now.busy = false;
    })();
  }, [key]);
  useEffect(() => {
    const now = memory.current;
    now.gone = false;
    return () => {
      now.gone = true;
    };
  }, []);
  return value;
}
