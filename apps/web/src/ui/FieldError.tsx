/** The error of a field and how to fix it, below the field. */
import { TriangleAlert } from "lucide";
import { Icon } from "./Icon.tsx";
import styles from "./field.module.css";

export function FieldError({ id, children }: { id?: string; children: string }) {
  return (
    <p id={id} className={styles["error"]} role="alert">
      <Icon of={TriangleAlert} size={16} />
      {children}
    </p>
  );
}
