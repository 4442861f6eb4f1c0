/** A checkbox with a label and an optional note below. */
import { useId } from "react";
import styles from "./field.module.css";

interface CheckboxProps {
  label: string;
  note?: string;
  checked: boolean;
  disabled?: boolean;
  onChange: (checked: boolean) => void;
}

export function Checkbox({ label, note, checked, disabled = false, onChange }: CheckboxProps) {
  const id = useId();
  return (
    <div className={styles["check"]}>
      <input
        id={id}
        type="checkbox"
        className={styles["box"]}
        checked={checked}
        disabled={disabled}
        aria-describedby={note === undefined ? undefined : `${id}-note`}
        onChange={(event) => onChange(event.target.checked)}
      />
      <label htmlFor={id} className={styles["checkWord"]}>
        {label}
      </label>
      {note !== undefined && (
        <p id={`${id}-note`} className={styles["checkNote"]}>
          {note}
        </p>
      )}
    </div>
  );
}
