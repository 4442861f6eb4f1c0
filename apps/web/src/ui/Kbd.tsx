/** A key of the keyboard, as it is printed on it. */
import styles from "./tag.module.css";

export function Kbd({ children }: { children: string }) {
  return <kbd className={styles["kbd"]}>{children}</kbd>;
}
