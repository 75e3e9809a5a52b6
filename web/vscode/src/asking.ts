// Questions about what changes while they are answered.

/**
 * Asks whenever it is called, one question at a time: what has changed meanwhile is asked once, after
 * the answer.
 * @param ask does not fail
 */
export function oneAtATime(ask: () => Promise<void>): () => void {
  let isAsking = false;
  /** Something has changed since the last question. */
  let isStale = false;
  const askUntilFresh = async () => {
    isAsking = true;
    while (isStale) {
      isStale = false;
      await ask();
    }
    isAsking = false;
  };
  return () => {
    isStale = true;
    if (!isAsking) void askUntilFresh();
  };
}
