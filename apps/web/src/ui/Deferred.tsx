/**
 * Mounts its children after the page around them, in short tasks, so that the robot can start and
 * report in between. Only for content that does not move other content.
 */
import { useDeferredValue, useState, type ReactNode } from "react";

interface DeferredProps {
  /** id of the element in index.html whose content is displayed until then */
  until?: string;
  children: ReactNode;
}

export function Deferred({ until, children }: DeferredProps) {
  // Cloned before React replaces the content of index.html.
  const [early] = useState(
    () => until && document.getElementById(until)?.cloneNode(true).childNodes,
  );
  if (useDeferredValue(true, false)) return children;
  // Nodes instead of markup: the page never parses text as HTML. The key prevents React from
  // reusing the element.
  return early ? (
    <div key="early" style={{ display: "contents" }} ref={(place) => place?.append(...early)} />
  ) : null;
}
