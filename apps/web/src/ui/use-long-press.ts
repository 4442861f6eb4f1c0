/** A button that does something else on a long press, or with Shift: for fingers, mouse and keyboard. */
import { useEffect, useRef, type MouseEvent, type PointerEvent } from "react";

const LONG_MS = 500;

/** @param press `isLong`: the press was long, or Shift was down. @returns what the button is given */
export function useLongPress(press: (isLong: boolean) => void) {
  const timer = useRef<ReturnType<typeof setTimeout>>(undefined);
  /** the long press has been answered: the click that follows is part of it */
  const isAnswered = useRef(false);
  useEffect(() => () => clearTimeout(timer.current), []);
  const end = () => clearTimeout(timer.current);
  return {
    onPointerDown: ({ button }: PointerEvent) => {
      isAnswered.current = false;
      end();
      if (button !== 0) return;
      timer.current = setTimeout(() => {
        isAnswered.current = true;
        press(true);
      }, LONG_MS);
    },
    onPointerUp: end,
    onPointerLeave: end,
    onPointerCancel: end,
    // A finger that rests must not open a menu over the button.
    onContextMenu: (event: MouseEvent) => event.preventDefault(),
    onClick: ({ shiftKey }: MouseEvent) => {
      end();
      if (!isAnswered.current) press(shiftKey);
      isAnswered.current = false;
    },
  };
}
