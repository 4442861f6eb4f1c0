/**
 * A small surface that floats at its button: menus and short panels, on the native Popover API.
 * The browser closes it on Escape and on a press elsewhere, and gives focus back.
 *
 * ```tsx
 * const menu = usePopover();
 * <Button {...menu.trigger}>View</Button>
 * <Popover {...menu.panel} label="View">…</Popover>
 * ```
 */
import { useId, useState, type ReactNode } from "react";
import { placePopover } from "./popover-place.ts";
import styles from "./popover.module.css";
import { classNames } from "./class-names.ts";

interface PopoverControl {
  /** for the button that opens it */
  trigger: { popoverTarget: string; "aria-expanded": boolean };
  /** for the Popover itself */
  panel: { id: string; isOpen: boolean; onOpenChange: (isOpen: boolean) => void };
  close: () => void;
}

/** One popover and the button that opens it. */
export function usePopover(): PopoverControl {
  const id = useId();
  const [isOpen, onOpenChange] = useState(false);
  return {
    trigger: { popoverTarget: id, "aria-expanded": isOpen },
    panel: { id, isOpen, onOpenChange },
    close: () => document.getElementById(id)?.hidePopover(),
  };
}

interface PopoverProps {
  id: string;
  isOpen: boolean;
  onOpenChange: (isOpen: boolean) => void;
  /** what it holds, for those who cannot see it */
  label: string;
  /** which edge of the button it shares; start is the left one unless the page runs right-to-left */
  align?: "start" | "end";
  className?: string | undefined;
  children: ReactNode;
}

/** Its content exists only while it is open. */
export function Popover({
  id,
  isOpen,
  onOpenChange,
  label,
  align = "start",
  className,
  children,
}: PopoverProps) {
  return (
    <dialog
      id={id}
      popover="auto"
      aria-label={label}
      className={classNames(styles["popover"], className)}
      onToggle={(event) => {
        // A details element inside tells of a toggle too; only our own counts.
        if (event.target !== event.currentTarget) return;
        onOpenChange(event.newState === "open");
      }}
    >
      {isOpen && (
        <div ref={(content) => keepPlaced(id, content, align)} className={styles["content"]}>
          {children}
        </div>
      )}
    </dialog>
  );
}

/**
 * Places it now, and again whenever its content or the window has another size: some of it may come
 * later, and a phone is turned.
 */
function keepPlaced(
  id: string,
  content: HTMLElement | null,
  align: "start" | "end",
): (() => void) | undefined {
  if (content === null) return undefined;
  const placeNow = () => place(id, content, align);
  const watch = new ResizeObserver(placeNow);
  watch.observe(content);
  window.addEventListener("resize", placeNow);
  placeNow();
  return () => {
    watch.disconnect();
    window.removeEventListener("resize", placeNow);
  };
}

/** Puts the popover at its button, once its content has a size. */
function place(id: string, content: HTMLElement, align: "start" | "end"): void {
  const popover = content.parentElement;
  const button = document.querySelector(`[popovertarget="${CSS.escape(id)}"]`);
  if (popover === null || button === null) return;
  const isMirrored = getComputedStyle(popover).direction === "rtl";
  const { left, top } = placePopover(
    button.getBoundingClientRect(),
    { width: popover.offsetWidth, height: popover.offsetHeight },
    { width: document.documentElement.clientWidth, height: window.innerHeight },
    (align === "start") === isMirrored ? "right" : "left",
  );
  popover.style.left = `${left}px`;
  popover.style.top = `${top}px`;
}

interface MenuItemProps {
  icon?: ReactNode;
  children: ReactNode;
  /** second, quieter line */
  note?: string;
  disabled?: boolean;
  /** whether the menu stays open when it is taken: it has something to ask first */
  staysOpen?: boolean;
  onSelect: () => void;
}

/** One choice of a menu in a Popover; the menu closes itself when it is taken. */
export function MenuItem({
  icon,
  children,
  note,
  disabled = false,
  staysOpen = false,
  onSelect,
}: MenuItemProps) {
  return (
    <button
      type="button"
      className={styles["item"]}
      disabled={disabled}
      onClick={(event) => {
        if (!staysOpen) event.currentTarget.closest<HTMLElement>("[popover]")?.hidePopover();
        onSelect();
      }}
    >
      {icon}
      <span className={styles["words"]}>
        {children}
        {note !== undefined && <span className={styles["note"]}>{note}</span>}
      </span>
    </button>
  );
}
