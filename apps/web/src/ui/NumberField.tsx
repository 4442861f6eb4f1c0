/** A number with its label above, and its error and an optional note below. */
import { useId } from "react";
import { FieldError } from "./FieldError.tsx";
import styles from "./field.module.css";
import { NumberInput } from "./NumberInput.tsx";
import type { NumberBounds } from "./number-text.ts";
import { useNumberDraft } from "./use-number-draft.ts";

interface NumberFieldProps {
  label: string;
  note?: string;
  value: number;
  bounds: NumberBounds;
  /** how to fix a number out of bounds */
  error: string;
  onChange: (value: number) => void;
}

export function NumberField(props: NumberFieldProps) {
  const { label, note, value, bounds, error, onChange } = props;
  const id = useId();
  const draft = useNumberDraft(value, bounds, onChange);
  return (
    <div className={styles["stack"]}>
      <label className={styles["label"]} htmlFor={id}>
        {label}
      </label>
      <NumberInput
        id={id}
        draft={draft}
        errorId={`${id}-error`}
        aria-describedby={note === undefined ? undefined : `${id}-note`}
      />
      {draft.hasErrorRoom && <FieldError id={`${id}-error`}>{error}</FieldError>}
      {note !== undefined && (
        <p id={`${id}-note`} className={styles["note"]}>
          {note}
        </p>
      )}
    </div>
  );
}
