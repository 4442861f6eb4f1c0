/** A QR code, drawn as elements, never as markup. */
import type { Ref } from "react";
import type { QrPath } from "./qr-path.ts";
import styles from "./qr-code.module.css";

export function QrCode({ code, ref }: { code: QrPath; ref?: Ref<SVGSVGElement> }) {
  return (
    <svg
      ref={ref}
      className={styles["code"]}
      viewBox={`0 0 ${code.size} ${code.size}`}
      shapeRendering="crispEdges"
      aria-hidden="true"
    >
      {/* Black on white in both themes: many scanners cannot read a light code on dark. */}
      <rect width={code.size} height={code.size} fill="white" />
      <path d={code.path} fill="black" />
    </svg>
  );
}
