/** Buttons: run (the only orange one), primary, outline and quiet; with or without an icon. */
import type { ComponentProps, ReactNode } from "react";
import styles from "./button.module.css";
import { classNames } from "./class-names.ts";

export type ButtonKind = "run" | "primary" | "outline" | "quiet";

export interface ButtonProps extends ComponentProps<"button"> {
  /** default: outline */
  kind?: ButtonKind;
  /** height: small 32 px, medium 36 px, large 44 px; every size is 44 px on touch screens */
  size?: "small" | "medium" | "large";
  icon?: ReactNode;
}

/** A native button whose `type` is "button", so that it never submits a form by accident. */
export function Button({
  kind = "outline",
  size = "medium",
  icon,
  className,
  children,
  ...rest
}: ButtonProps) {
  return (
    <button
      type="button"
      {...rest}
      className={classNames(styles["button"], styles[kind], styles[size], className)}
    >
      {icon}
      {children}
    </button>
  );
}

interface IconButtonProps extends Omit<ComponentProps<"button">, "aria-label" | "title"> {
  /** accessible name and tooltip */
  label: string;
  /** default: quiet */
  kind?: ButtonKind;
  size?: "small" | "medium" | "large";
}

/** A square button that shows only an icon (its child). */
export function IconButton({
  label,
  kind = "quiet",
  size = "small",
  className,
  ...rest
}: IconButtonProps) {
  return (
    <button
      type="button"
      {...rest}
      aria-label={label}
      title={label}
      className={classNames(
        styles["button"],
        styles["iconOnly"],
        styles[kind],
        styles[size],
        className,
      )}
    />
  );
}
