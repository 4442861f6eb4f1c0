/**
 * Moves the focus to a field of a list that grows. A button that adds a field names it before React
 * renders it: the field then takes the focus, so that typed text does not go to the button.
 */
import { useRef } from "react";

interface FieldFocus<Key> {
  /** focuses a field, at once or when it appears */
  focus: (key: Key) => void;
  /** the `ref` of a field */
  refOf: (key: Key) => (field: HTMLElement | null) => void;
}

export function useFieldFocus<Key>(): FieldFocus<Key> {
  const fields = useRef(new Map<Key, HTMLElement>());
  const awaited = useRef<Key | null>(null);
  return {
    focus: (key) => {
      const field = fields.current.get(key);
      if (field === undefined) awaited.current = key;
      else field.focus();
    },
    refOf: (key) => (field) => {
      if (field === null) {
        fields.current.delete(key);
        return;
      }
      fields.current.set(key, field);
      if (awaited.current !== key) return;
      awaited.current = null;
      field.focus();
    },
  };
}
