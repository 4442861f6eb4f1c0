/** One line of text with its label above, and an optional note below. */
import { useId, type ComponentProps } from "react";
import { classNames } from "./class-names.ts";
import styles from "./field.module.css";

interface TextFieldProps extends Omit<ComponentProps<"input">, "onChange" | "className"> {
  label: string;
  note?: string;
  value: string;
  onChange: (value: string) => void;
}

export function TextField({ label, note, onChange, ...rest }: TextFieldProps) {
  const id = useId();
  return (
    <div className={styles["stack"]}>
      <label className={styles["label"]} htmlFor={id}>
        {label}
      </label>
      <input
        aria-describedby={note === undefined ? undefined : `${id}-note`}
        {...rest}
        id={id}
        type="text"
        autoComplete="off"
        className={classNames(styles["field"], styles["text"])}
        onChange={(event) => onChange(event.target.value)}
      />
      {note !== undefined && (
        <p id={`${id}-note`} className={styles["note"]}>
          {note}
        </p>
      )}
    </div>
  );
}
