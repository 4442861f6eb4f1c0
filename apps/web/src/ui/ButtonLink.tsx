/** A link that looks like a button. */
import type { ComponentProps, ReactNode } from "react";
import type { ButtonProps } from "./Button.tsx";
import styles from "./button.module.css";
import { classNames } from "./class-names.ts";

interface ButtonLinkProps
  extends Pick<ButtonProps, "kind" | "size">, Omit<ComponentProps<"a">, "className"> {
  href: string;
  icon?: ReactNode;
}

export function ButtonLink({
  kind = "outline",
  size = "medium",
  icon,
  children,
  ...rest
}: ButtonLinkProps) {
  return (
    <a {...rest} className={classNames(styles["button"], styles[kind], styles[size])}>
      {icon}
      {children}
    </a>
  );
}
