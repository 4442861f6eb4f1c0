/** Code to read, select and copy. A field instead of a `pre`: every browser can scroll it by keyboard. */
import code from "./code-field.module.css";

interface CodeFieldProps {
  label: string;
  /** lines in sight */
  lines: number;
  text: string;
}

export function CodeField({ label, lines, text }: CodeFieldProps) {
  return (
    <textarea
      dir="ltr"
      className={code["code"]}
      readOnly
      rows={lines}
      wrap="off"
      spellCheck={false}
      aria-label={label}
      value={text}
    />
  );
}
