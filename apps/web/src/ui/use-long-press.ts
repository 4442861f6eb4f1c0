/**
 * A button with a second function on a long press or with Shift: for fingers, mouse and keyboard.
 */
import { useEffect, useRef, type MouseEvent, type PointerEvent } from "react";

const LONG_MS = 500;

/**
 * @param press `isLong`: the press was long, or Shift was pressed
 * @returns props of the button
 */
export function useLongPress(press: (isLong: boolean) => void) {
  const timer = useRef<ReturnType<typeof setTimeout>>(undefined);
  /** whether the long press was handled: the click that follows is part of it */
  const isHandled = useRef(false);
  useEffect(() => () => clearTimeout(timer.current), []);
  const end = () => clearTimeout(timer.current);
  return {
    onPointerDown: ({ button }: PointerEvent) => {
      isHandled.current = false;
      end();
      if (button !== 0) return;
      timer.current = setTimeout(() => {
        isHandled.current = true;
        press(true);
      }, LONG_MS);
    },
    onPointerUp: end,
    onPointerLeave: end,
    onPointerCancel: end,
    // A resting finger must not open a context menu over the button.
    onContextMenu: (event: MouseEvent) => event.preventDefault(),
    onClick: ({ shiftKey }: MouseEvent) => {
      end();
      if (!isHandled.current) press(shiftKey);
      isHandled.current = false;
    },
  };
}
