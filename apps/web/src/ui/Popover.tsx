/**
 * A small panel at its button: menus and short forms, on the native Popover API. The browser closes
 * it on Escape and on a press outside, and restores focus.
 *
 * ```tsx
 * const menu = usePopover();
 * <Button {...menu.trigger}>View</Button>
 * <Popover {...menu.panel} label="View">…</Popover>
 * ```
 */
import { useId, useState, type ReactNode } from "react";
import { placePopover } from "./popover-position.ts";
import styles from "./popover.module.css";
import { classNames } from "./class-names.ts";

interface PopoverControl {
  /** props of the button that opens it */
  trigger: { popoverTarget: string; "aria-expanded": boolean };
  /** props of the Popover itself */
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
  /** accessible name */
  label: string;
  /** the edge that it shares with the button; start is left, or right in right-to-left pages */
  align?: "start" | "end";
  className?: string | undefined;
  children: ReactNode;
}

/** Its content is mounted only while it is open. */
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
      // It opens with this event, because a toggle event comes later: the button may be gone by then.
      onBeforeToggle={({ newState }) => {
        if (newState === "open") onOpenChange(true);
      }}
      onToggle={(event) => {
        // A details element inside sends toggle events, too.
        if (event.target !== event.currentTarget) return;
        if (event.newState === "closed") onOpenChange(false);
      }}
    >
      {isOpen && (
        <div ref={(content) => observePosition(id, content, align)} className={styles["content"]}>
          {children}
        </div>
      )}
    </dialog>
  );
}

/**
 * Positions it now and after each resize of its content or the window: content may load later, and
 * phones rotate.
 */
function observePosition(
  id: string,
  content: HTMLElement | null,
  align: "start" | "end",
): (() => void) | undefined {
  if (content === null) return undefined;
  const update = () => place(id, content, align);
  const observer = new ResizeObserver(update);
  observer.observe(content);
  window.addEventListener("resize", update);
  update();
  return () => {
    observer.disconnect();
    window.removeEventListener("resize", update);
  };
}

/** Positions the popover at its button once its content has a size. */
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
  /** whether the menu stays open after a selection, for items that ask a question first */
  staysOpen?: boolean;
  onSelect: () => void;
}

/** One item of a menu in a Popover. Selecting it closes the menu. */
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
