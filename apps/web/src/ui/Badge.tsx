/** The square number of a program line: the same badge wherever that line is meant. */
import type { ReactNode } from "react";
import styles from "./tag.module.css";
import { classNames } from "./class-names.ts";

interface BadgeProps {
  /** rest: ink; live: this line runs; bad: this line bumped */
  tone?: "rest" | "live" | "bad";
  /** the number, or a picture where no numbered line is meant */
  children: ReactNode;
  className?: string | undefined;
}

export function Badge({ tone = "rest", children, className }: BadgeProps) {
  return <span className={classNames(styles["badge"], styles[tone], className)}>{children}</span>;
}
