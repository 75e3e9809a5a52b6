// What is needed rarely, behind a button with three points: a menu that the keyboard walks through.

import { useLayoutEffect, useRef, useState } from "preact/hooks";

export interface MenuItem {
  text: string;
  /** What it does in more words. */
  title?: string;
  onChosen: () => void;
}

export function Menu({ label, items }: { label: string; items: MenuItem[] }) {
  const [isOpen, setOpen] = useState(false);
  const box = useRef<HTMLDivElement>(null);
  const button = useRef<HTMLButtonElement>(null);
  const buttons = () => [...(box.current?.querySelectorAll<HTMLElement>("[role=menuitem]") ?? [])];
  const close = () => {
    setOpen(false);
    button.current?.focus();
  };
  // With the menu itself: a click that follows at once closes it, too.
  useLayoutEffect(() => {
    if (!isOpen) return undefined;
    buttons()[0]?.focus();
    const closeOutside = ({ target }: Event) => {
      if (!box.current?.contains(target as Node)) setOpen(false);
    };
    document.addEventListener("pointerdown", closeOutside);
    return () => {
      document.removeEventListener("pointerdown", closeOutside);
    };
  }, [isOpen]);
  const walk = (event: KeyboardEvent) => {
    if (!isOpen) return;
    const all = buttons();
    const at = all.indexOf(document.activeElement as HTMLElement);
    const places: Record<string, number> = {
      ArrowDown: (at + 1) % all.length,
      ArrowUp: (at + all.length - 1) % all.length,
      Home: 0,
      End: all.length - 1,
    };
    const place = places[event.key];
    if (event.key === "Escape") close();
    else if (event.key === "Tab") setOpen(false);
    else if (place !== undefined) all[place]?.focus();
    if (event.key === "Escape" || place !== undefined) event.preventDefault();
  };
  return (
    <div class="menu" ref={box} onKeyDown={walk}>
      <button
        ref={button}
        type="button"
        class="tool"
        aria-label={label}
        title={label}
        aria-haspopup="menu"
        aria-expanded={isOpen}
        onClick={() => {
          setOpen(!isOpen);
        }}
      >
        <svg viewBox="0 0 16 16" aria-hidden="true">
          <path d="M2 6.500h3v3H2zM6.500 6.500h3v3h-3zM11 6.500h3v3h-3z" />
        </svg>
      </button>
      {isOpen && (
        <div class="menu-items" role="menu" aria-label={label}>
          {items.map(({ text, title, onChosen }) => (
            <button
              key={text}
              type="button"
              role="menuitem"
              class="quiet"
              tabIndex={-1}
              title={title}
              onClick={() => {
                close();
                onChosen();
              }}
            >
              {text}
            </button>
          ))}
        </div>
      )}
    </div>
  );
}
