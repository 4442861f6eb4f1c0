/** A state in a small capsule: an icon and a word, never colour alone. */
import type { ReactNode } from "react";
import { classNames } from "./class-names.ts";
import styles from "./tag.module.css";

interface ChipProps {
  /** ring: waiting; live: happening; good, bad: how it ended; dashed: never happened */
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
