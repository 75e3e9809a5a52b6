// How long the video of a run is, and which time of the run each of its moments shows.
// Tested by test/timing.test.ts.

export const framesPerSecond = 30;

/** A video is as long as its run, but within these limits. */
const shortestMs = 3000;
const longestMs = 10_000;
/** So long it shows the start: a busy browser loses what it is given before its encoder runs. */
const startMs = 400;
/** So long it shows the end before it begins anew. */
const endMs = 700;

/** How long the video of a run is that takes `runMs`. */
export function videoLength(runMs: number): number {
  return Math.min(longestMs, Math.max(shortestMs, startMs + runMs + endMs));
}

/** So many times as fast as the card the video is. */
export function speedOf(runMs: number): number {
  return runMs / (videoLength(runMs) - startMs - endMs);
}

/** The time of the run that is shown when the video has played for `videoMs`. */
export function timeShown(videoMs: number, runMs: number): number {
  return Math.min(runMs, Math.max(0, videoMs - startMs) * speedOf(runMs));
}
