// The link of the open project.

import { useRef, useState } from "preact/hooks";

import { Dialog } from "../panel/dialog.js";
import { texts } from "../texts/texts.js";
import { shareLink } from "../workspace.js";

export function ShareDialog({ onClose }: { onClose: () => void }) {
  const { share: t } = texts.value;
  const field = useRef<HTMLTextAreaElement>(null);
  const [link] = useState(shareLink);
  const [isCopied, setIsCopied] = useState(false);
  const copy = async () => {
    field.current?.select();
    try {
      await navigator.clipboard.writeText(link);
      setIsCopied(true);
    } catch {
      // Without permission the selected text can be copied by hand.
    }
  };
  return (
    <Dialog title={t.title} onClose={onClose}>
      <p>{t.text}</p>
      <label>
        {t.link}
        <textarea ref={field} readOnly rows={4} value={link} />
      </label>
      <div class="row">
        <button type="button" onClick={() => void copy()}>
          {t.copy}
        </button>
        <span role="status">{isCopied ? t.copied : ""}</span>
      </div>
    </Dialog>
  );
}
