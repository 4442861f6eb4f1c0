/** A text in a field that selects itself, and the button that copies it. */
import { useId, useRef, useState } from "react";
import { CopyButton } from "./CopyButton.tsx";
import labels from "./field.module.css";
import styles from "./copy-field.module.css";

interface CopyFieldProps {
  label: string;
  text: string;
  /** of the button */
  copy: string;
  /** after the text was copied */
  copied: string;
  /** where the browser refuses to copy: how to do it by hand */
  byHand: string;
  /** "link": with a visible label and a button beside the field; "code": one frame around both */
  look: "link" | "code";
}

export function CopyField({ label, text, copy, copied, byHand, look }: CopyFieldProps) {
  const id = useId();
  const field = useRef<HTMLInputElement>(null);
  const [isByHand, setByHand] = useState(false);
  return (
    <div className={styles["stack"]} data-look={look}>
      <label className={look === "link" ? labels["label"] : "visually-hidden"} htmlFor={id}>
        {label}
      </label>
      <div className={styles["row"]}>
        <input
          id={id}
          ref={field}
          dir="ltr"
          className={styles["text"]}
          readOnly
          value={text}
          onFocus={(event) => event.target.select()}
        />
        <CopyButton
          text={text}
          label={copy}
          done={copied}
          kind={look === "link" ? "primary" : "quiet"}
          size={look === "link" ? "large" : "medium"}
          onRefused={() => {
            field.current?.focus();
            field.current?.select();
            setByHand(true);
          }}
        />
      </div>
      <output className={styles["note"]}>{isByHand ? byHand : ""}</output>
    </div>
  );
}
