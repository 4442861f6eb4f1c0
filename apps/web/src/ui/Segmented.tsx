/** A choice between few visible options: a native radio group in one track. */
import { useId, type ReactNode } from "react";
import { classNames } from "./class-names.ts";
import styles from "./segmented.module.css";

interface SegmentedOption<Value extends string> {
  value: Value;
  label: string;
  icon?: ReactNode;
  /** why an option has no effect now; it looks disabled but can be chosen */
  fixed?: string | undefined;
}

interface SegmentedProps<Value extends string> {
  /** accessible name of the group; visible only with `showLabel` */
  label: ReactNode;
  showLabel?: boolean;
  value: Value;
  options: readonly SegmentedOption<Value>[];
  onChange: (value: Value) => void;
  /**
   * "track" fills the width on a sunken track; "strip" is as wide as its labels, on a raised bar
   */
  look?: "track" | "strip";
}

export function Segmented<Value extends string>({
  label,
  showLabel = false,
  value,
  options,
  onChange,
  look = "track",
}: SegmentedProps<Value>) {
  const name = useId();
  return (
    <fieldset>
      <legend className={showLabel ? styles["legend"] : "visually-hidden"}>{label}</legend>
      <div className={classNames(styles["options"], styles[look])}>
        {options.map((option) => (
          <label key={option.value} className={styles["option"]}>
            <input
              type="radio"
              className={styles["radio"]}
              name={name}
              value={option.value}
              checked={option.value === value}
              aria-disabled={option.fixed !== undefined || undefined}
              title={option.fixed}
              onChange={() => onChange(option.value)}
            />
            {option.icon}
            <span className={styles["word"]}>{option.label}</span>
          </label>
        ))}
      </div>
    </fieldset>
  );
}
