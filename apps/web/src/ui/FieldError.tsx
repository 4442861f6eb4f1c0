/** The error of a field and how to fix it, below the field. */
import { TriangleAlert } from "lucide-react";
import styles from "./field.module.css";

export function FieldError({ id, children }: { id: string; children: string }) {
  return (
    <p id={id} className={styles["error"]} role="alert">
      <TriangleAlert size={16} aria-hidden="true" />
      {children}
    </p>
  );
}
