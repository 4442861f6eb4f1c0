/**
 * A text that changes with the run. React renders its element once; after that its text node is
 * written directly. In a box of fixed size it causes no other layout.
 */
import { useLayoutEffect, useRef } from "react";
import { followText, type StateSource } from "./follow-text.ts";

interface LiveTextProps<State> {
  of: StateSource<State>;
  /** must be a stable function: a new one is subscribed again */
  text: (state: State) => string;
  className?: string | undefined;
}

export function LiveText<State>({ of, text, className }: LiveTextProps<State>) {
  const element = useRef<HTMLSpanElement>(null);
  useLayoutEffect(() => {
    const node = document.createTextNode("");
    element.current?.replaceChildren(node);
    return followText(of, text, (next) => (node.data = next));
  }, [of, text]);
  return <span ref={element} className={className} />;
}
