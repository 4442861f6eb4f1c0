/** The bar and the content of the pages of a class. */
import type { ReactNode } from "react";
import { Brand } from "../../ui/Brand.tsx";
import styles from "./dashboard.module.css";

interface DashboardFrameProps {
  bar: ReactNode;
  /** at the end of the bar */
  end: ReactNode;
  /** whether the sheet of a student is open */
  hasSheet?: boolean;
  children: ReactNode;
}

export function DashboardFrame({ bar, end, hasSheet, children }: DashboardFrameProps) {
  return (
    <div className={styles["page"]}>
      <header className={styles["bar"]}>
        <a className={styles["brand"]} href="/teach">
          <Brand />
        </a>
        {bar}
        <div className={styles["end"]}>{end}</div>
      </header>
      <main className={styles["main"]} data-sheet={hasSheet}>
        {children}
      </main>
    </div>
  );
}
