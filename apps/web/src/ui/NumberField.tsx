/** A number with its label above and, while it is not one, the way to mend it below. */
import { TriangleAlert } from "lucide-react";
import { useId, type ComponentProps } from "react";
import { classNames } from "./class-names.ts";
import styles from "./field.module.css";
import type { NumberBounds } from "./number-text.ts";
import { useNumberDraft, type NumberDraft } from "./use-number-draft.ts";

interface NumberFieldProps extends NumberBounds {
  label: string;
  value: number;
  /** called with each legal number as soon as it is typed */
  onChange: (value: number) => void;
  /** shown while the text is not a legal number: "Type a distance from 0 to 100000." */
  errorText: string;
}

export function NumberField({ label, value, onChange, errorText, ...bounds }: NumberFieldProps) {
  const draft = useNumberDraft(value, bounds, onChange);
  const id = useId();
  const errorId = `${id}-error`;
  return (
    <div className={styles["stack"]}>
      <label className={styles["label"]} htmlFor={id}>
        {label}
      </label>
      <NumberInput id={id} draft={draft} errorId={errorId} />
      {draft.isInvalid && <FieldError id={errorId}>{errorText}</FieldError>}
    </div>
  );
}

interface NumberInputProps extends Omit<ComponentProps<"input">, "value" | "onChange"> {
  draft: NumberDraft;
  /** id of the element that tells the error */
  errorId: string;
}

/** The bare field, where label and error have their places elsewhere. */
export function NumberInput({ draft, errorId, className, onBlur, ...rest }: NumberInputProps) {
  return (
    <input
      {...rest}
      type="text"
      inputMode="decimal"
      autoComplete="off"
      className={classNames(styles["field"], styles["number"], className)}
      value={draft.text}
      aria-invalid={draft.isInvalid}
      aria-describedby={draft.isInvalid ? errorId : undefined}
      onChange={(event) => draft.type(event.target.value)}
      onBlur={(event) => {
        draft.leave();
        onBlur?.(event);
      }}
    />
  );
}

/** What is wrong with a field and how to mend it. */
export function FieldError({ id, children }: { id: string; children: string }) {
  return (
    <p id={id} className={styles["error"]} role="alert">
      <TriangleAlert size={16} aria-hidden="true" />
      {children}
    </p>
  );
}
