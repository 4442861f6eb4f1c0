/**
 * What is being typed into a number field. The text may be half a number; the value outside only
 * ever sees whole, legal ones, and the last of them comes back when the field is left.
 */
import { useState } from "react";
import { readNumber, type NumberBounds } from "./number-text.ts";

interface Draft {
  text: string;
  /** the outer value while this was typed: when that changes from elsewhere, the draft is void */
  value: number;
}

export interface NumberDraft {
  text: string;
  isInvalid: boolean;
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
  const isTyping = draft !== null && draft.value === value;
  const text = isTyping ? draft.text : String(value);
  return {
    text,
    isInvalid: isTyping && readNumber(text, bounds) === null,
    type: (next) => {
      const number = readNumber(next, bounds);
      setDraft({ text: next, value: number ?? value });
      if (number !== null && number !== value) onChange(number);
    },
    leave: () => setDraft(null),
  };
}
