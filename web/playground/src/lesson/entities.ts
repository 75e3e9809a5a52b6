// Stands for the package `entities` in the bundle (tools/bundle.js): the browser knows the names of
// characters, so that the page does not bring their table. Tested by e2e/teacher.spec.ts.

const parser = new DOMParser();

/** A text whose entities, such as `&frac12;`, have become characters. */
export function decodeHTML(text: string): string {
  // White space at the begin of a document would be left out.
  const { body } = parser.parseFromString(`.${text}`, "text/html");
  return body.textContent.slice(1);
}
