// How the page in a panel and the extension speak: what the extension says is kept, and shown together.

/** Tells the extension what the reader wants. */
export type Tell<FromView> = (message: FromView) => void;

declare function acquireVsCodeApi(): { postMessage(message: unknown): void };

/** `show` gets all that has been said, of each member the last one, and what was said just now. */
export function openPanel<ToView extends object, FromView>(
  show: (main: HTMLElement, said: ToView, now: ToView, tell: Tell<FromView>) => void,
): void {
  const host = acquireVsCodeApi();
  const main = document.querySelector("main");
  let said = {} as ToView;
  addEventListener("message", ({ data }: MessageEvent<ToView>) => {
    said = { ...said, ...data };
    if (!main) return;
    show(main, said, data, (message) => {
      host.postMessage(message);
    });
  });
  host.postMessage("ready");
}
