// The focus goes from panel to panel.

/** To the next panel that is seen, or the one before; after the last one comes the first. */
export function focusPanel(step: 1 | -1): void {
  const shown = [...document.querySelectorAll<HTMLElement>("main .panel")].filter(
    ({ offsetParent }) => offsetParent !== null,
  );
  const current = shown.findIndex((panel) => panel.contains(document.activeElement));
  const from = current < 0 && step < 0 ? 0 : current;
  shown.at((from + step) % shown.length)?.focus();
}
