/** What a field means, below the field. */
import styles from "./field-note.module.css";

export function FieldNote({ id, children }: { id: string; children: string }) {
  return (
    <p id={id} className={styles["note"]}>
      {children}
    </p>
  );
}
