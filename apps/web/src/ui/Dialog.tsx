/**
 * A modal dialog on the native element: it traps focus, closes on Escape, and restores focus. On
 * phones it is a sheet of full height.
 */
import { X } from "lucide";
import { useEffect, useId, useRef, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { IconButton } from "./Button.tsx";
import { classNames } from "./class-names.ts";
import { Icon } from "./Icon.tsx";
import styles from "./dialog.module.css";

interface DialogProps {
  isOpen: boolean;
  onClose: () => void;
  title: string;
  /** one sentence under the title */
  subtitle?: string;
  /** wide: 816 px (share); narrow: 480 px */
  width?: "wide" | "narrow";
  /** a quiet bar at the bottom */
  footer?: ReactNode;
  /** whether the content has no controls: it can then be focused, so that keys scroll it */
  isText?: boolean;
  children: ReactNode;
}

/** Stays mounted while closed, so that the browser can restore focus; its content does not. */
export function Dialog({
  isOpen,
  onClose,
  title,
  subtitle,
  width = "wide",
  footer,
  isText = false,
  children,
}: DialogProps) {
  const { t } = useTranslation();
  const dialog = useRef<HTMLDialogElement>(null);
  const titleId = useId();
  useEffect(() => {
    const element = dialog.current;
    if (isOpen && element?.open === false) element.showModal();
    if (!isOpen && element?.open === true) element.close();
  }, [isOpen]);
  return (
    <dialog
      ref={dialog}
      className={classNames(styles["dialog"], styles[width])}
      aria-labelledby={titleId}
      onClose={onClose}
      onPointerDown={(event) => {
        // The frame has no padding: a press on the dialog element itself is a press on the
        // backdrop.
        if (event.target === event.currentTarget) onClose();
      }}
    >
      {isOpen && (
        <div className={styles["frame"]}>
          <div className={styles["header"]}>
            <div>
              <h2 id={titleId} className={styles["title"]}>
                {title}
              </h2>
              {subtitle !== undefined && <p className={styles["subtitle"]}>{subtitle}</p>}
            </div>
            <IconButton label={t("shell.close")} size="medium" onClick={onClose}>
              <Icon of={X} />
            </IconButton>
          </div>
          {isText ? (
            // oxlint-disable-next-line jsx-a11y/no-noninteractive-tabindex
            <section className={styles["content"]} tabIndex={0} aria-labelledby={titleId}>
              {children}
            </section>
          ) : (
            <div className={styles["content"]}>{children}</div>
          )}
          {footer !== undefined && <div className={styles["footer"]}>{footer}</div>}
        </div>
      )}
    </dialog>
  );
}
