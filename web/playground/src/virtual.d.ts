/** The lessons of web/lessons; tools/bundle.js puts them in. */
declare module "virtual:lessons" {
  import type { Lesson } from "@oncard/lessons";
  const lessons: Lesson[];
  export default lessons;
}
