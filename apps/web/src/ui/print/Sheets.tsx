/**
 * The printed sheets. They are beside the page, which the print leaves out; on the screen they are
 * not visible.
 */
import { useEffect, type ReactNode } from "react";
import { createPortal } from "react-dom";
import { setPageSizes, type PageName } from "./page-size.ts";
import type { PaperName } from "./paper.ts";
import styles from "./print.module.css";

interface SheetsProps {
  paper: PaperName;
  /** direction of the first sheet */
  first: PageName;
  children: ReactNode;
}

export function Sheets({ paper, first, children }: SheetsProps) {
  useEffect(() => setPageSizes(paper, first), [paper, first]);
  return createPortal(
    <div className={styles["sheets"]} aria-hidden="true">
      {children}
    </div>,
    document.body,
  );
}
