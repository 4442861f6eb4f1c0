/**
 * A text that moves with the run. React renders its element once; from then on it is written straight
 * to its text node. Give it a box of its own size, and nothing else on the page is laid out with it.
 */
import { useLayoutEffect, useRef } from "react";
import { followText, type Followed } from "./follow-text.ts";

interface LiveTextProps<State> {
  of: Followed<State>;
  /** the same function each time while it says the same: a new one is followed anew */
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
