/**
 * The logo, defined in index.html, where it is displayed before any script; on phones only its C.
 */
import styles from "./brand.module.css";

export function Brand() {
  return (
    <h1 className={styles["brand"]}>
      <svg className={styles["wordmark"]} viewBox="0 0 107.33 30" aria-hidden="true">
        <use href="#wordmark" />
      </svg>
      <span className="visually-hidden">Corridor</span>
    </h1>
  );
}
