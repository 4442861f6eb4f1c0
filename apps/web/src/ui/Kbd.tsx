/** A key of the keyboard as printed on it: "Alt+↓" in every script. */
import styles from "./tag.module.css";

export function Kbd({ children }: { children: string }) {
  return (
    <kbd dir="ltr" className={styles["kbd"]}>
      {children}
    </kbd>
  );
}
