// Records what is painted on a canvas, as the browser encodes it.

import { framesPerSecond } from "./timing.js";

/** What browsers can write, the best one first; Safari knows MP4 alone. */
const types = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/mp4"];
/** Lines and texts stay sharp. */
const bitsPerSecond = 5_000_000;

/** How this browser can record; nothing if it cannot. */
export function typeOfVideo(): string | undefined {
  if (typeof MediaRecorder === "undefined") return undefined;
  if (!("captureStream" in HTMLCanvasElement.prototype)) return undefined;
  return types.find((type) => MediaRecorder.isTypeSupported(type));
}

/** Without its codecs. */
function containerOf(type: string): string {
  return type.replace(/;.*/, "");
}

/** The name of a file with a video, by the type of its content. */
export function videoName(type: string): string {
  return type.startsWith("video/mp4") ? "oncard.mp4" : "oncard.webm";
}

interface Recording {
  canvas: HTMLCanvasElement;
  type: string;
  lengthMs: number;
  /** Paints what is there after so much time, at the beginning of a frame. */
  paint: (videoMs: number) => void;
  signal: AbortSignal;
}

/** Takes as long as the video. Nothing if it was aborted, or the browser has failed. */
export function recordVideo(recording: Recording): Promise<Blob | undefined> {
  const { canvas, type, paint, signal } = recording;
  paint(0);
  const stream = canvas.captureStream(framesPerSecond);
  const options = { mimeType: type, videoBitsPerSecond: bitsPerSecond };
  const recorder = new MediaRecorder(stream, options);
  const pieces: Blob[] = [];
  /** Of everything that listens and paints. */
  const over = new AbortController();
  let isWhole = false;
  return new Promise((resolve) => {
    recorder.addEventListener("dataavailable", ({ data }) => pieces.push(data));
    const stop = () => {
      if (recorder.state !== "inactive") recorder.stop();
    };
    recorder.addEventListener("start", () => {
      play(recording, recorder, over.signal, () => {
        isWhole = true;
        stop();
      });
    });
    // It comes after a failure, too.
    recorder.addEventListener("stop", () => {
      over.abort();
      for (const track of stream.getTracks()) track.stop();
      resolve(isWhole ? new Blob(pieces, { type: containerOf(type) }) : undefined);
    });
    signal.addEventListener("abort", stop, { signal: over.signal });
    recorder.start();
  });
}

/**
 * Paints each frame when it is due. A slow computer leaves frames out, so that the video is as long.
 * While the page is hidden, both wait: browsers slow its clocks down.
 */
function play(
  { lengthMs, paint }: Recording,
  recorder: MediaRecorder,
  over: AbortSignal,
  onEnd: () => void,
): void {
  let begin = performance.now();
  let hiddenAt = begin;
  const timer = setInterval(() => {
    if (document.hidden) return;
    const passed = performance.now() - begin;
    const frame = Math.floor((passed / 1000) * framesPerSecond);
    paint(Math.min(lengthMs, (frame * 1000) / framesPerSecond));
    if (passed >= lengthMs) onEnd();
  }, 1000 / framesPerSecond);
  over.addEventListener("abort", () => {
    clearInterval(timer);
  });
  const wait = () => {
    if (document.hidden) {
      hiddenAt = performance.now();
      recorder.pause();
    } else {
      begin += performance.now() - hiddenAt;
      recorder.resume();
    }
  };
  document.addEventListener("visibilitychange", wait, { signal: over });
}
