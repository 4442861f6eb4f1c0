/** A field for a number while it is typed. Label and error are rendered around it. */
import type { ComponentProps } from "react";
import { classNames } from "./class-names.ts";
import styles from "./field.module.css";
import type { NumberDraft } from "./use-number-draft.ts";

interface NumberInputProps extends Omit<ComponentProps<"input">, "value" | "onChange"> {
  draft: Omit<NumberDraft, "hasErrorRoom">;
  /** id of the element with the error */
  errorId: string;
}

export function NumberInput({ draft, errorId, className, onBlur, ...rest }: NumberInputProps) {
  return (
    <input
      {...rest}
      type="text"
      // A minus sign precedes its digits in every script.
      dir="ltr"
      inputMode="decimal"
      autoComplete="off"
      className={classNames(styles["field"], styles["number"], className)}
      value={draft.text}
      aria-invalid={draft.isInvalid}
      aria-describedby={draft.isInvalid ? errorId : rest["aria-describedby"]}
      onChange={(event) => draft.type(event.target.value)}
      onBlur={(event) => {
        draft.leave();
        onBlur?.(event);
      }}
    />
  );
}
