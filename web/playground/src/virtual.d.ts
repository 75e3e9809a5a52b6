/** The lessons and samples of web/lessons; tools/bundle.js puts them in. */
declare module "virtual:lessons" {
  import type { Lesson } from "@oncard/lessons";
  export const offered: Lesson[];
  export const samples: Lesson[];
  /** By the names of the samples. */
  export const pictures: Record<string, import("./lesson/picture.js").Picture>;
}
