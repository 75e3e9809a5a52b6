/**
 * The words of an instruction as `oncard dump` writes them: the length with as many words as it
 * counts, then the link words.
 */
export function recordText(words: readonly number[]): string {
  const length = (words[0] ?? 0) + 1;
  return `${hexadecimal(words.slice(0, length))}  ${hexadecimal(words.slice(length))}`;
}

function hexadecimal(words: readonly number[]): string {
  return words.map((word) => word.toString(16).toUpperCase().padStart(4, "0")).join(" ");
}
