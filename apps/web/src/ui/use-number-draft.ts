/**
 * What is being typed into a number field. The text may be half a number; the value outside only
 * ever sees whole, legal ones, and the last of them comes back when the field is left.
 *
 * A press elsewhere leaves the field when the button goes down. If the error went away then, what
 * stands below would move from under the pointer, and the press would be no click: its room is kept
 * until the press is over.
 */
import { useEffect, useRef, useState } from "react";
import { readNumber, type NumberBounds } from "./number-text.ts";

interface Draft {
  text: string;
  /** the outer value while this was typed: when that changes from elsewhere, the draft is void */
  value: number;
}

export interface NumberDraft {
  text: string;
  isInvalid: boolean;
  /** whether the error takes its room: while it is to be seen, and on to the end of a press */
  hasErrorRoom: boolean;
  type: (text: string) => void;
  leave: () => void;
}

/** @param onChange called with each legal number as soon as it is typed */
export function useNumberDraft(
  value: number,
  bounds: NumberBounds,
  onChange: (value: number) => void,
): NumberDraft {
  const [draft, setDraft] = useState<Draft | null>(null);
  const [keepsRoom, setKeepsRoom] = useState(false);
  const isTyping = draft !== null && draft.value === value;
  const text = isTyping ? draft.text : String(value);
  const isInvalid = isTyping && readNumber(text, bounds) === null;
  const hasErrorRoom = isInvalid || keepsRoom;
  const isPressing = usePressing(hasErrorRoom, () => setKeepsRoom(false));
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
      setKeepsRoom(isInvalid && isPressing());
      setDraft(null);
    },
  };
}

/**
 * Watches for presses while there is an error that they could move. It listens to the mouse, since
 * it is the mouse event, for a finger too, that takes the focus and makes the click.
 * @returns whether a button is down now
 */
function usePressing(isWatching: boolean, onEnd: () => void): () => boolean {
  const isPressing = useRef(false);
  const end = useRef(onEnd);
  useEffect(() => {
    end.current = onEnd;
  });
  useEffect(() => {
    if (!isWatching) return;
    const watch = new AbortController();
    const options = { capture: true, signal: watch.signal };
    window.addEventListener("mousedown", () => (isPressing.current = true), options);
    // A menu of the browser or a drag may swallow the release: a key or the next press ends it too.
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
      watch.abort();
      isPressing.current = false;
    };
  }, [isWatching]);
  return () => isPressing.current;
}
