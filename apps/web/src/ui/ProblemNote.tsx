/** What went wrong and what to do, announced at once. */
import { TriangleAlert } from "lucide";
import type { ReactNode } from "react";
import { Icon } from "./Icon.tsx";
import styles from "./problem-note.module.css";

export function ProblemNote({ children }: { children: ReactNode }) {
  return (
    <div className={styles["problem"]} role="alert">
      <Icon of={TriangleAlert} size={18} />
      <div>{children}</div>
    </div>
  );
}

/** The place and the values behind a problem. */
export function ProblemDetail({ children }: { children: ReactNode }) {
  return <p className={styles["detail"]}>{children}</p>;
}
