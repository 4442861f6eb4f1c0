/** The bar and the content of the pages of a class. */
import type { ReactNode } from "react";
import { Brand } from "../../ui/Brand.tsx";
import { classNames } from "../../ui/class-names.ts";
import layout from "../../ui/page.module.css";
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
    <div className={layout["page"]}>
      <header className={classNames(layout["bar"], styles["bar"])}>
        <a className={classNames(layout["brand"], styles["brand"])} href="/teach">
          <Brand />
        </a>
        {bar}
        <div className={classNames(layout["end"], styles["end"])}>{end}</div>
      </header>
      <main className={classNames(layout["main"], styles["main"])} data-sheet={hasSheet}>
        {children}
      </main>
    </div>
  );
}
