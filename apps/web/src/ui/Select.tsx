/** A styled native select, so that phones show their own picker and keys work as usual. */
import { ChevronDown } from "lucide";
import type { ComponentProps, ReactNode } from "react";
import { classNames } from "./class-names.ts";
import { Icon } from "./Icon.tsx";
import styles from "./field.module.css";

interface SelectProps<Value extends string> extends Omit<
  ComponentProps<"select">,
  "value" | "onChange" | "aria-label" | "children"
> {
  /** accessible name; the caller renders a visible label */
  label: string;
  value: Value;
  options: readonly { value: Value; label: string }[];
  onChange: (value: Value) => void;
  /** icon of the chosen value, before its label */
  icon?: ReactNode;
}

export function Select<Value extends string>({
  label,
  value,
  options,
  onChange,
  icon,
  className,
  ...rest
}: SelectProps<Value>) {
  return (
    <span
      className={classNames(styles["select"], icon !== undefined && styles["withIcon"], className)}
    >
      {icon !== undefined && (
        <span className={styles["icon"]} aria-hidden="true">
          {icon}
        </span>
      )}
      <select
        {...rest}
        className={styles["field"]}
        aria-label={label}
        value={value}
        onChange={(event) => {
          const chosen = options.find((option) => option.value === event.target.value);
          if (chosen !== undefined) onChange(chosen.value);
        }}
      >
        {options.map((option) => (
          <option key={option.value} value={option.value}>
            {option.label}
          </option>
        ))}
      </select>
      <Icon of={ChevronDown} className={styles["caret"]} size={16} />
    </span>
  );
}
