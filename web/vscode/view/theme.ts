// The colours of threads for dark and light themes of the editor, which names its theme at the body.

export function followTheme(): void {
  const { body, documentElement } = document;
  const take = () => {
    const isDark = body.matches(
      ".vscode-dark, .vscode-high-contrast:not(.vscode-high-contrast-light)",
    );
    documentElement.dataset["theme"] = isDark ? "dark" : "light";
  };
  take();
  new MutationObserver(take).observe(body, { attributeFilter: ["class"] });
}
