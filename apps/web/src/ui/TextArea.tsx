/** Several lines of text with their label above. */
import { useId, type ComponentProps } from "react";
import { classNames } from "./class-names.ts";
import styles from "./field.module.css";

interface TextAreaProps extends Omit<ComponentProps<"textarea">, "onChange" | "className"> {
  label: string;
  value: string;
  onChange: (value: string) => void;
}

export function TextArea({ label, onChange, ...rest }: TextAreaProps) {
  const id = useId();
  return (
    <div className={styles["stack"]}>
      <label className={styles["label"]} htmlFor={id}>
        {label}
      </label>
      <textarea
        rows={3}
        {...rest}
        id={id}
        autoComplete="off"
        className={classNames(styles["field"], styles["text"], styles["area"])}
        onChange={(event) => onChange(event.target.value)}
      />
    </div>
  );
}
