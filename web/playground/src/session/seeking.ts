// Going to moments: to the last one that was wished for, when the one before has been reached.

import { bench } from "./bench.js";

let wished: number | undefined;
let isGoing = false;

export function seek(moment: number): void {
  wished = moment;
  if (isGoing) return;
  isGoing = true;
  void (async () => {
    while (wished !== undefined) {
      const to: number = wished;
      wished = undefined;
      await bench.goTo({ moment: to });
    }
    isGoing = false;
  })();
}
