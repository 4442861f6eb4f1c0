/** The number of a program line, with the same look wherever that line is meant. */
import type { ReactNode } from "react";
import styles from "./tag.module.css";
import { classNames } from "./class-names.ts";

interface BadgeProps {
  /** rest: ink; live: the line runs; bad: the line caused a bump */
  tone?: "rest" | "live" | "bad";
  /** the number, or an icon for something other than a numbered line */
  children: ReactNode;
  className?: string | undefined;
}

export function Badge({ tone = "rest", children, className }: BadgeProps) {
  return <span className={classNames(styles["badge"], styles[tone], className)}>{children}</span>;
}
