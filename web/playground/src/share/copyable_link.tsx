// A link, or a text with one, that can be copied.

import { useRef, useState } from "preact/hooks";

import { texts } from "../texts/texts.js";

export function CopyableLink({ label, link }: { label: string; link: string }) {
  const { share: t } = texts.value;
  const field = useRef<HTMLTextAreaElement>(null);
  const [copied, setCopied] = useState<string>();
  const copy = async () => {
    field.current?.select();
    try {
      await navigator.clipboard.writeText(link);
      setCopied(link);
    } catch {
      // Without permission the selected text can be copied by hand.
    }
  };
  return (
    <>
      <label>
        {label}
        <textarea ref={field} readOnly rows={4} value={link} />
      </label>
      {link.startsWith("#") && <p>{t.fragment}</p>}
      <div class="row">
        <button type="button" onClick={() => void copy()}>
          {t.copy}
        </button>
        <span role="status">{copied === link ? t.copied : ""}</span>
      </div>
    </>
  );
}
