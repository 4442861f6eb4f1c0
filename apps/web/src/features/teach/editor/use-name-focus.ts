import { useEffect, useEffectEvent, useRef, type RefObject } from "react";

/**
 * The ref of a name that takes the focus, with its text selected, while it is wanted.
 * @param onNamed called when it has the focus
 */
export function useNameFocus(
  isWanted: boolean,
  onNamed: () => void,
): RefObject<HTMLInputElement | null> {
  const field = useRef<HTMLInputElement>(null);
  const focus = useEffectEvent(() => {
    field.current?.focus();
    field.current?.select();
    onNamed();
  });
  useEffect(() => {
    if (isWanted) focus();
  }, [isWanted]);
  return field;
}
