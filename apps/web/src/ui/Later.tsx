/**
 * What can wait until the page around it stands: it is mounted right after that, in short pieces, so
 * that the robot can be started and told of in between. Only for what leaves its place free.
 */
import { useDeferredValue, useState, type ReactNode } from "react";

interface LaterProps {
  /** id of the element in index.html whose content keeps standing here until then */
  until?: string;
  children: ReactNode;
}

export function Later({ until, children }: LaterProps) {
  // Read while the document's own house is still there: React is about to take its place.
  const [early] = useState(
    () => until && document.getElementById(until)?.cloneNode(true).childNodes,
  );
  if (useDeferredValue(true, false)) return children;
  // Nodes and no markup: the page turns no text into elements. The key keeps React from using their place again.
  return early ? (
    <div key="early" style={{ display: "contents" }} ref={(place) => place?.append(...early)} />
  ) : null;
}
