/**
 * What can wait until the page around it stands: it is mounted right after that, in short pieces, so
 * that the robot can be started and told of in between. Only for what leaves its place free.
 */
import { useDeferredValue, type ReactNode } from "react";

export function Later({ children }: { children: ReactNode }) {
  return useDeferredValue(true, false) ? children : null;
}
