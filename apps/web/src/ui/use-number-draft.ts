/**
 * The draft of a number field. The text may be an incomplete number; the outer value receives only
 * valid numbers, and the last of them is restored on blur.
 *
 * A press elsewhere blurs the field on mousedown. If the error disappeared at that moment, the
 * content below would move away from the pointer and the press would be no click. The error's space
 * is therefore retained until the press ends.
 */
import { useEffect, useRef, useState } from "react";
import { readNumber, type NumberBounds } from "./number-text.ts";

interface Draft {
  text: string;
  /**
   * the outer value while this was typed; if that changes from elsewhere, the draft is discarded
   */
  value: number;
}

export interface NumberDraft {
  text: string;
  isInvalid: boolean;
  /** whether the error takes up space: while it is displayed, and until the end of a press */
  hasErrorRoom: boolean;
  type: (text: string) => void;
  leave: () => void;
}

/** @param onChange receives each valid number as it is typed */
export function useNumberDraft(
  value: number,
  bounds: NumberBounds,
  onChange: (value: number) => void,
): NumberDraft {
  const [draft, setDraft] = useState<Draft | null>(null);
  const [holdsRoom, setHoldsRoom] = useState(false);
  const isTyping = draft !== null && draft.value === value;
  const text = isTyping ? draft.text : String(value);
  const isInvalid = isTyping && readNumber(text, bounds) === null;
  const hasErrorRoom = isInvalid || holdsRoom;
  const isPressing = usePressing(hasErrorRoom, () => setHoldsRoom(false));
  return {
    text,
    isInvalid,
    hasErrorRoom,
    type: (next) => {
      const number = readNumber(next, bounds);
      setDraft({ text: next, value: number ?? value });
      if (number !== null && number !== value) onChange(number);
    },
    leave: () => {
      setHoldsRoom(isInvalid && isPressing());
      setDraft(null);
    },
  };
}

/**
 * Observes presses while there is an error that they could move. It uses mouse events, which move
 * the focus and create the click for fingers, too.
 * @returns whether a button is pressed now
 */
function usePressing(isActive: boolean, onEnd: () => void): () => boolean {
  const isPressing = useRef(false);
  const end = useRef(onEnd);
  useEffect(() => {
    end.current = onEnd;
  });
  useEffect(() => {
    if (!isActive) return;
    const listeners = new AbortController();
    const options = { capture: true, signal: listeners.signal };
    window.addEventListener("mousedown", () => (isPressing.current = true), options);
    // A browser menu or a drag may swallow the release: a key or the next press ends it, too.
    for (const type of ["mouseup", "dragend", "keydown"]) {
      window.addEventListener(
        type,
        () => {
          isPressing.current = false;
          end.current();
        },
        options,
      );
    }
    return () => {
      listeners.abort();
      isPressing.current = false;
    };
  }, [isActive]);
  return () => isPressing.current;
}
