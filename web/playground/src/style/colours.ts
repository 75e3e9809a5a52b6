// Colours and fonts of tokens.css for what is drawn on a canvas.

/** What a token is in the colours that are shown now: `token("--ink")`. */
export function token(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** There are so many colours of channels; then they begin anew. */
export const channelColours = 8;

/** The colour of a channel, by its place. */
export function channelColour(index: number): string {
  return token(`--channel-${index % channelColours}`);
}
