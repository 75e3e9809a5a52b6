// Stands for the package `punycode.js` in the bundle (tools/bundle.js): the browser writes the names of
// hosts in ASCII itself. Tested by e2e/teacher.spec.ts.

export default {
  toASCII(host: string): string {
    return new URL(`https://${host}`).hostname;
  },
  /** Only for the words of a link that is nothing but an address: they stay as they were written. */
  toUnicode(host: string): string {
    return host;
  },
};
