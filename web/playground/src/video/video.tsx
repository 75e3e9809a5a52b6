// A video that has been recorded.

import { useEffect, useState } from "preact/hooks";

import { wantsStill } from "../lesson/opening.js";
import { texts } from "../texts/texts.js";
import { frameHeight, frameWidth } from "./layout.js";

export function Video({ video }: { video: Blob }) {
  const [address, setAddress] = useState<string>();
  useEffect(() => {
    const its = URL.createObjectURL(video);
    setAddress(its);
    return () => {
      URL.revokeObjectURL(its);
    };
  }, [video]);
  const still = wantsStill();
  return (
    <video
      src={address}
      width={frameWidth}
      height={frameHeight}
      aria-label={texts.value.video.video}
      loop
      muted
      playsInline
      autoPlay={!still}
      controls={still}
    />
  );
}
