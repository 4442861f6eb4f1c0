/** A titled part of the form. */
import { useId, type ReactNode } from "react";
import styles from "./form.module.css";

export function FormSection({ title, children }: { title: string; children: ReactNode }) {
  const id = useId();
  return (
    <section className={styles["section"]} aria-labelledby={id}>
      <h3 id={id} className={styles["title"]}>
        {title}
      </h3>
      {children}
    </section>
  );
}
