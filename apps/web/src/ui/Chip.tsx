/** A state in a small capsule: an icon and a word, never colour alone. */
import type { ReactNode } from "react";
import { classNames } from "./class-names.ts";
import styles from "./tag.module.css";

interface ChipProps {
  /** ring: waiting; live: in progress; good, bad: ended; dashed: never started */
  tone: "ring" | "live" | "good" | "bad" | "dashed";
  icon: ReactNode;
  children: string;
}

export function Chip({ tone, icon, children }: ChipProps) {
  return (
    <span className={classNames(styles["chip"], styles[tone])}>
      {icon}
      {children}
    </span>
  );
}
