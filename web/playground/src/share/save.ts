// Files that the page hands to the reader.

/** After this time the browser has taken over what it saves. */
const takenOverMs = 1000;

export function save(name: string, content: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => {
    URL.revokeObjectURL(link.href);
  }, takenOverMs);
}
