/** A table of the report, with its title. It scrolls on its own where it is wider than the page. */
import type { ReactNode } from "react";
import { classNames } from "../../../ui/class-names.ts";
import styles from "./report.module.css";

interface ReportTableProps {
  title: string;
  /** the first one names the rows */
  columns: readonly string[];
  /** rows */
  children: ReactNode;
  /** below the table */
  notes?: ReactNode;
}

export function ReportTable({ title, columns, children, notes }: ReportTableProps) {
  return (
    <div className={styles["section"]}>
      <h3 className={styles["heading"]}>{title}</h3>
      {/* oxlint-disable-next-line jsx-a11y/no-noninteractive-tabindex -- scrolls by keyboard */}
      <section className={styles["scroll"]} tabIndex={0} aria-label={title}>
        <table className={styles["table"]}>
          <thead>
            <tr>
              {columns.map((column, at) => (
                <th key={column} scope="col" className={classNames(at > 0 && styles["end"])}>
                  {column}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>{children}</tbody>
        </table>
      </section>
      {notes}
    </div>
  );
}
